import os
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._view import View

__version__: str

Path = Union[str, os.PathLike[str]]

Whole = Union[int, np.integer[Any]]
Number = Union[float, np.floating[Any], Whole]

Numbers = Union[Sequence[Number], NDArray[Any]]
Corners = Union[Sequence[ArrayLike], NDArray[Any]]
Limits = Union[Number, Numbers]

class Error(RuntimeError):
    """What was given makes no sense; one line that names the file or the argument, and the value."""

class Body:
    """A rigid body: one or more shapes in its own frame. Lengths are in the scene's unit."""
    @staticmethod
    def disc(radius: Number) -> Body:
        """A disc, in the plane; radius 0 is a point"""
    @staticmethod
    def sphere(radius: Number) -> Body:
        """A sphere, in space; radius 0 is a point"""
    @staticmethod
    def box(x: Number, y: Number, z: Optional[Number] = None) -> Body:
        """A rectangle about the origin, or with z a box, with these extents"""
    @staticmethod
    def planar_capsule(radius: Number, length: Number) -> Body:
        """All points of the plane within radius of a segment along x about the origin"""
    @staticmethod
    def capsule(radius: Number, length: Number) -> Body:
        """All points of space within radius of a segment along z about the origin"""
    @staticmethod
    def cylinder(radius: Number, length: Number) -> Body:
        """A cylinder along z about the origin, in space"""
    @staticmethod
    def convex(points: ArrayLike) -> Body:
        """The convex polygon (points of shape (n, 2)) or polytope ((n, 3)) with these corners"""
    @staticmethod
    def convex_hull(points: ArrayLike) -> Body:
        """The convex hull of at most 256 points, of shape (n, 2) or (n, 3)"""
    @staticmethod
    def mesh(vertices: ArrayLike, faces: ArrayLike, dimension: Whole = 3) -> Body:
        """A triangle mesh: vertices of shape (n, 3), faces of shape (m, 3). With dimension 2 it is for a planar scene:
        it keeps its z, and moves in x and y."""
    @staticmethod
    def mesh_file(file: Path, dimension: Whole = 3, keep_axes: bool = False, scale: Number = 1.0) -> Body:
        """The mesh of a COLLADA, STL, OBJ or PLY file. COLLADA files are turned so that y is up, as in OMPL.app, unless
        keep_axes is true, as in ROS. scale is 0.001 for a file in millimeters and a scene in meters."""
    @staticmethod
    def join(members: Sequence[Tuple[Body, Optional[ArrayLike]]]) -> Body:
        """One body of several: a list of pairs of a body and its pose (see Scene.add_obstacle)"""
    @property
    def dimension(self) -> int:
        """The dimension of the workspace: 2 or 3"""
    @property
    def bounding_radius(self) -> float:
        """The largest distance of a point of the body from the origin of its frame"""
    def signed_distance(self, points: ArrayLike) -> NDArray[np.float64]:
        """The distances of points, of shape (n, dimension) in the body's frame; negative inside primitives. Shape
        (n,)"""
    def padded(self, padding: Number) -> Body:
        """The same shapes with a padding: a body that keeps this distance from obstacles, exactly, with round corners.
        Two robots keep the sum of their paddings. It takes the place of a padding that the body has; 0 for none."""
    @property
    def padding(self) -> float:
        """The distance that the body keeps from obstacles"""

class Zone:
    """A box that a rigid robot or a car with a trailer shall get into: a goal of all states with its position there,
    however it is turned"""
    def __init__(self, low: ArrayLike, high: ArrayLike) -> None:
        """low and high bound the position, with 2 or 3 numbers."""
    @property
    def low(self) -> List[float]:
        """The least numbers of the position"""
    @property
    def high(self) -> List[float]:
        """The largest numbers of the position"""

class AnyOf:
    """Several goals of a robot, any of which will do: such as docks, grasps, or the states that an inverse kinematics
    of your own found"""
    def __init__(self, goals: Iterable[Union[ArrayLike, AnyOf, LinkPose, Zone]]) -> None:
        """goals are states, and whatever else may be a goal of that robot: a Zone, a LinkPose. The goals of an AnyOf
        among them are taken out of it."""
    @property
    def goals(self) -> List[Union[ArrayLike, AnyOf, LinkPose, Zone]]:
        """The goals: a list"""

class LinkPose:
    """Where a link of an arm shall be, such as its tool: a goal of all states in which it is there"""
    def __init__(
        self,
        link: str,
        position: Optional[ArrayLike] = None,
        rotation: Optional[ArrayLike] = None,
        *,
        point: Optional[ArrayLike] = None,
        position_tolerance: Optional[ArrayLike] = None,
        rotation_tolerance: Optional[ArrayLike] = None,
    ) -> None:
        """position is where point, in the link's frame, shall be in the workspace: anywhere if it is None. rotation, a
        matrix of shape (3, 3) or (qx, qy, qz, qw), is how the link shall be turned: any way if it is None. In the plane
        points have 2 numbers, and the rotation is an angle. The tolerances are one number or three, 0.001 and 0.01 if
        they are None: how far off the point may be along the workspace's axes, and the link about its own: XYZ Euler
        angles, in radians. From pi on any turn about that axis will do, and the angles are XZY if that is the y
        axis."""
    @property
    def link(self) -> str:
        """The name of the link"""

class AttachedBody:
    """A body that an arm carries, such as what it has grasped"""
    def __init__(
        self, name: str, link: str, body: Body, pose: Optional[ArrayLike] = None, touch_links: Sequence[str] = ...
    ) -> None:
        """pose is in the frame of the link that holds the body. The two are not checked against each other, nor are the
        body and the touch_links, such as fingers. No link may have that name."""

class TouchableObstacle:
    """An obstacle that some links of an arm may touch, such as the table that a part stands on"""
    def __init__(
        self, name: str, body: Body, pose: Optional[ArrayLike] = None, touch_links: Sequence[str] = ...
    ) -> None:
        """pose is in the workspace. touch_links are links and attached bodies. All other links of the arm are checked
        against it. It counts as a link of the arm, which must not have that name, and is not to be added to the scene.
        Other robots must not touch it; an arm that has one of that name, too, heeds its own alone."""

class ArmFile:
    """The description of an arm, read once: a URDF file, in meters, and an SRDF file. Arms of one ArmFile share their
    meshes and all that is made of them. So make the arm anew from it when it grasps something, which then takes
    milliseconds."""
    def __init__(
        self, urdf: Path, srdf: Path = "", packages: Mapping[str, Path] = ..., visuals: bool = False
    ) -> None:
        """The arguments are those of Robot.arm."""
    @property
    def name(self) -> str:
        """The robot's name, by the URDF file"""
    @property
    def groups(self) -> List[str]:
        """The names of the groups of joints. Without an SRDF file there is one, without a name, of all joints that can
        move."""
    def joints(self, group: str = "") -> List[str]:
        """The joints of a group, in the order of the numbers of a state"""
    def states(self, group: str = "") -> Dict[str, NDArray[np.float64]]:
        """See Robot.arm_states."""
    def arm(
        self,
        group: str = "",
        name: Optional[str] = None,
        base: Optional[ArrayLike] = None,
        joint_values: Mapping[str, Number] = ...,
        bounds: Optional[Corners] = None,
        attached: Sequence[AttachedBody] = ...,
        touchable: Sequence[TouchableObstacle] = ...,
        may_touch_obstacles: Sequence[str] = ...,
        padding: Union[Number, Mapping[str, Number]] = 0.0,
    ) -> Robot:
        """An arm. The arguments are those of Robot.arm."""
    def arms(
        self,
        groups: Mapping[str, str],
        base: Optional[ArrayLike] = None,
        joint_values: Mapping[str, Number] = ...,
        bounds: Optional[Corners] = None,
        attached: Sequence[AttachedBody] = ...,
        touchable: Sequence[TouchableObstacle] = ...,
        may_touch_obstacles: Sequence[str] = ...,
        padding: Union[Number, Mapping[str, Number]] = 0.0,
    ) -> List[Robot]:
        """The arms of one mechanism. The arguments are those of Robot.arms."""

class Robot:
    """One member of a team: a rigid body, a car with a trailer, an arm, or a robot that moves by controls"""
    @staticmethod
    def rigid(
        name: str,
        body: Body,
        low: ArrayLike,
        high: ArrayLike,
        turns: bool = True,
        turning_radius: Optional[Number] = None,
        *,
        keep_out: Sequence[Tuple[Body, Optional[ArrayLike]]] = ...,
    ) -> Robot:
        """A robot of one body. low and high bound its position, with 2 or 3 numbers. A state is x, y and, if it turns,
        the angle in radians; in space x, y, z and the quaternion qx, qy, qz, qw. With a turning_radius it drives as a
        car does, forward and backward along the curves of Reeds and Shepp; its x axis points ahead. keep_out lists
        zones that this robot alone must not enter, pairs of a body and its pose."""
    @staticmethod
    def car_with_trailer(
        name: str,
        car: Body,
        trailer: Body,
        hitch_length: Number,
        low: ArrayLike,
        high: ArrayLike,
        *,
        keep_out: Sequence[Tuple[Body, Optional[ArrayLike]]] = ...,
    ) -> Robot:
        """A car that pulls a trailer in the plane: x, y, its angle, the trailer's angle. It moves straight from state
        to state, also sideways, as if it had no wheels: to drive take Robot.car with a trailer, and plan_controls().
        keep_out lists zones that it must not enter, pairs of a body and its pose."""
    @staticmethod
    def integrator(
        name: str,
        body: Body,
        low: ArrayLike,
        high: ArrayLike,
        velocity: ArrayLike,
        acceleration: Optional[ArrayLike] = None,
        *,
        keep_out: Sequence[Tuple[Body, Optional[ArrayLike]]] = ...,
    ) -> Robot:
        """A robot that moves by controls and does not turn. Its controls are its velocities along the axes; with an
        acceleration its accelerations, and then the velocities are part of its state. Limits are a number v for -v to v
        along each axis, or (low, high), or an array of shape (dimension, 2). keep_out is that of Robot.rigid."""
    @staticmethod
    def unicycle(
        name: str,
        body: Body,
        low: ArrayLike,
        high: ArrayLike,
        linear: Limits,
        angular: Limits,
        linear_acceleration: Optional[Limits] = None,
        angular_acceleration: Optional[Limits] = None,
        *,
        keep_out: Sequence[Tuple[Body, Optional[ArrayLike]]] = ...,
    ) -> Robot:
        """A robot in the plane that moves by controls: along its heading, and by turns. Its controls are these two
        speeds; with both accelerations these, and then the speeds are part of its state. Limits are a number v for -v
        to v, or (low, high). keep_out is that of Robot.rigid."""
    @staticmethod
    def car(
        name: str,
        body: Body,
        low: ArrayLike,
        high: ArrayLike,
        speed: Limits,
        steering: Limits,
        wheelbase: Number,
        trailer: Optional[Body] = None,
        hitch_length: Optional[Number] = None,
        max_hinge_angle: Optional[Number] = None,
        *,
        keep_out: Sequence[Tuple[Body, Optional[ArrayLike]]] = ...,
    ) -> Robot:
        """A car that moves by controls: the speed of its rear axle, where its frame's origin is, and the steering
        angle. Limits are a number v for -v to v, or (low, high). wheelbase is the distance between the axles. With a
        trailer, whose origin is hitch_length behind the car's, the headings of both differ by at most max_hinge_angle.
        keep_out is that of Robot.rigid."""
    @staticmethod
    def arm(
        urdf: Path,
        srdf: Path = "",
        group: str = "",
        name: Optional[str] = None,
        base: Optional[ArrayLike] = None,
        joint_values: Mapping[str, Number] = ...,
        bounds: Optional[Corners] = None,
        attached: Sequence[AttachedBody] = ...,
        packages: Mapping[str, Path] = ...,
        visuals: bool = False,
        may_touch_obstacles: Sequence[str] = ...,
        touchable: Sequence[TouchableObstacle] = ...,
        padding: Union[Number, Mapping[str, Number]] = 0.0,
    ) -> Robot:
        """An arm from a URDF file, in meters, and an SRDF file that names the group of joints to plan for. base is the
        pose of its root link; joint_values are those of joints that are not of the group. A planar or floating joint in
        the group needs bounds of its position, (low, high), of 2 or 3 numbers. attached are bodies that it carries.
        packages tells the folders of packages that meshes are in (package://name/...), where they are not around the
        URDF file; visuals takes visual geometry in place of that for collisions. may_touch_obstacles are links, and
        attached bodies, that are not checked against obstacles, such as the foot of a robot that is bolted to a table;
        touchable are obstacles that some of them may touch. A state has the values of the group's joints, in radians or
        meters. padding is the distance that all links and attached bodies keep from obstacles, or a dict of those that
        keep one, by their names; see Body.padded. An attached body that is padded keeps its own. The arm's links are
        checked against each other without. For several arms of the same files take an ArmFile. What was ignored in the
        files is told by warnings."""
    @staticmethod
    def arms(
        urdf: Path,
        srdf: Path,
        groups: Mapping[str, str],
        base: Optional[ArrayLike] = None,
        joint_values: Mapping[str, Number] = ...,
        bounds: Optional[Corners] = None,
        attached: Sequence[AttachedBody] = ...,
        packages: Mapping[str, Path] = ...,
        visuals: bool = False,
        may_touch_obstacles: Sequence[str] = ...,
        touchable: Sequence[TouchableObstacle] = ...,
        padding: Union[Number, Mapping[str, Number]] = 0.0,
    ) -> List[Robot]:
        """The arms of one mechanism as several robots, such as both arms of a torso. groups tells the group of joints
        that each moves, by the robot's name: {'left': 'left_arm', 'right': 'right_arm'}. A link belongs to the robot
        that moves it, and links that none moves to the first. The rest is as for arm()."""
    @staticmethod
    def arm_states(
        urdf: Path, srdf: Path, group: str, packages: Mapping[str, Path] = ..., visuals: bool = False
    ) -> Dict[str, NDArray[np.float64]]:
        """The states that the SRDF file names for a group, such as home: a dict of arrays, each a state of the group's
        arm. Those that lack a joint of the group are left out. packages and visuals are as for arm()."""
    @property
    def name(self) -> str:
        """The robot's name, unique in its team"""
    @property
    def bodies(self) -> List[Body]:
        """The bodies that the robot moves"""
    @property
    def coordinates(self) -> List[str]:
        """The names of the numbers of a state"""
    @property
    def bounds(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """From where to where the numbers of a state may be: two arrays, low and high. A joint without limits, and an
        angle, is from -pi to pi."""
    @property
    def control_names(self) -> List[str]:
        """The names of its controls; none if it moves without"""
    @property
    def dimension(self) -> int:
        """The dimension of the workspace: 2 or 3"""
    @property
    def links(self) -> List[str]:
        """Of an arm, the name of the link of each body"""
    def link_pose(self, state: ArrayLike, link: str) -> NDArray[np.float64]:
        """Of an arm, where the frame of a link is in a state, such as that of its tool: a matrix, of shape (4, 4)"""
    def sample_goal(self, goal: Union[AnyOf, LinkPose, Zone], count: Whole = 1, seed: Whole = 1) -> NDArray[np.float64]:
        """Random states of a LinkPose, a Zone or an AnyOf, of shape (count, coordinates); fewer rows if no more are
        found. This is the inverse kinematics of an arm. Bounds are kept, collisions do not matter."""
    def reach(self, goal: LinkPose, state: ArrayLike) -> Optional[NDArray[np.float64]]:
        """The state of a LinkPose that an arm reaches from a state on by small changes of its joints, of shape
        (coordinates,); None if the search got stuck. Bounds are kept, collisions do not matter."""
    def goal_distance(self, goal: Union[AnyOf, LinkPose, Zone], state: ArrayLike) -> float:
        """How far a state is from a LinkPose, a Zone or an AnyOf; 0 if it is in it. For a LinkPose lengths beyond the
        position's tolerances and radians beyond the rotation's are added."""
    def poses(self, state: ArrayLike) -> NDArray[np.float64]:
        """Where each body is in a state: matrices, of shape (bodies, 4, 4). Bodies of an arm have frames of their own,
        see link_pose."""

class Scene:
    """A workspace with obstacles, and robots with their starts and goals. Lengths are in the scene's unit, angles in
    radians."""
    def __init__(self, low: ArrayLike, high: ArrayLike, name: str = "scene") -> None:
        """A scene without obstacles and robots. low and high bound the workspace, with 2 or 3 numbers."""
    def add_obstacle(self, body: Body, pose: Optional[ArrayLike] = None, name: str = "") -> int:
        """Add an obstacle and return its number, from 0 on. pose is (x, y) or (x, y, angle) in the plane, (x, y, z) or
        (x, y, z, qx, qy, qz, qw) in space, or a 4 × 4 matrix. Messages call it by its name, if it has one."""
    def add_cloud(self, points: ArrayLike, radius: Number, cell: Number = 0.0) -> int:
        """Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of the cloud,
        from 0 on. All within radius of a point is occupied. With a cell larger than 0 fewer points stand for them, one
        in each cell of a grid; the radius grows, so that all that was occupied still is, and what Checker.change_cloud
        inserts has that larger radius, too. In a planar scene points of shape (n, 2) are in the robots' way at any
        height. Of those of shape (n, 3) only the ones count that are within radius of the heights of a robot's meshes
        with their padding; so add the robots first. Robots of other shapes reach all heights, so leave out the floor
        before."""
    def add_cloud_file(self, file: Path, radius: Number, cell: Number = 0.0) -> int:
        """The same, from a PCD or PLY file, or a text: .xyz, .txt, .asc, .pts or .csv"""
    def add_grid(self, occupied: ArrayLike, size: Number, first: ArrayLike = (), origin: ArrayLike = ()) -> int:
        """Add obstacles that are cells of a grid with edges of length size, and return its number; clouds, grids and
        maps are numbered together, from 0 on. occupied has bools, of shape (nx, ny) in the plane or (nx, ny, nz). Cell
        (i, j) reaches from (i, j) to (i + 1, j + 1), times size, from origin on, by default 0; first is the index of
        occupied[0, 0], by default 0."""
    def add_occupancy_map_file(self, file: Path, unknown_occupied: bool = False) -> int:
        """Add the occupied cells of a map of ROS's map_server, from its .yaml file and the image that this names, and
        return its number. For planar scenes. Unknown cells are free, or occupied; beyond the map all is free."""
    def add_octomap_file(
        self,
        file: Path,
        depth: Whole = 16,
        unknown_occupied: bool = False,
        heights: Optional[Numbers] = None,
        origin: Numbers = (),
    ) -> int:
        """Add the occupied cells of an octomap, from a .bt or .ot file, and return its number. Each level of depth less
        doubles the edges of its smallest cells. Unknown cells are free; or occupied, within the box of all known ones.
        In a planar scene those cells count that reach into the heights (low, high). origin is where the map's own
        origin is in the scene, with 3 numbers, by default 0."""
    def add_octomap(
        self,
        data: Union[bytes, ArrayLike],
        resolution: Number,
        binary: bool = True,
        id: str = "OcTree",
        *,
        depth: Whole = 16,
        unknown_occupied: bool = False,
        heights: Optional[Numbers] = None,
        origin: Numbers = (),
    ) -> int:
        """The same, from the fields of ROS's message octomap_msgs/Octomap: data as bytes, an array or a list of
        numbers."""
    def add_robot(
        self,
        robot: Robot,
        start: ArrayLike,
        goal: Union[ArrayLike, AnyOf, LinkPose, Zone],
        weight: Number = 1.0,
        speed: Number = 1.0,
    ) -> None:
        """Add a robot, with its start and goal; its distances count weight times. The goal may also be a LinkPose, for
        an arm, a Zone, or an AnyOf. speed is how much of its distance it moves in a unit of time: times of plans, and
        the objectives makespan and arrival, go by it."""
    @property
    def name(self) -> str:
        """What the scene is called"""
    @property
    def dimension(self) -> int:
        """The dimension of the workspace: 2 or 3"""
    @property
    def low(self) -> NDArray[np.float64]:
        """The lower bounds of the workspace, of shape (dimension,)"""
    @property
    def high(self) -> NDArray[np.float64]:
        """The upper bounds of the workspace, of shape (dimension,)"""
    @property
    def notes(self) -> List[str]:
        """What a user should know about how files were read, and about angles of robots that look like degrees"""
    @property
    def robots(self) -> List[Robot]:
        """The robots, in the order of the numbers of a state"""
    @property
    def obstacle_count(self) -> int:
        """The number of obstacles that are bodies"""
    @property
    def coordinates(self) -> List[str]:
        """The names of the numbers of a state of the team, such as scout.x"""
    @property
    def state_bounds(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """From where to where the numbers of a state of the team may be: two arrays, low and high"""
    @property
    def start(self) -> NDArray[np.float64]:
        """The team's start, of shape (coordinates,)"""
    @property
    def goal(self) -> NDArray[np.float64]:
        """The team's goal, of shape (coordinates,); for a LinkPose, a Zone or an AnyOf, one state of many"""
    resolution: float
    """The longest step between samples of a motion, as a fraction of each robot's extent: from 1e-6 to below 1, or 0
    for OMPL's own"""
    def first_robots(self, count: Whole) -> Scene:
        """The same scene with the first robots alone"""
    def validate(self) -> None:
        """Raise an Error unless the team can stand at its start and goal."""
    def load_path(self, file: Path) -> NDArray[np.float64]:
        """The states of a path that Plan.save() wrote, or another program: comma-separated values whose first line
        names the columns, in any order. Columns that are no coordinates are passed over. An array of shape (states,
        coordinates), as for Checker.prove()"""
    def save_picture(self, file: Path) -> None:
        """Write a picture of the scene, as SVG. The name must end in .svg."""

class Checker:
    """Checks states and motions of a scene's team, and keeps what is known of the obstacles. Later changes of the scene
    do not reach it. Threads may share it."""
    def __init__(self, scene: Scene, method: str = "shared", motion: str = "discrete") -> None:
        """method: shared, partial, basic, standard or fcl. motion: discrete or continuous."""
    def is_valid(self, states: ArrayLike) -> Any:
        """Which states are valid: for an array of shape (n, coordinates) bools of shape (n,), for one state a bool. One
        with a number that is not finite is not valid. Bounds are not checked. Other Python threads run meanwhile, and
        Ctrl-C raises KeyboardInterrupt."""
    def clearance(self, states: ArrayLike) -> Any:
        """Lower bounds of the distance to the nearest contact: with an obstacle, between robots, or between links of
        one arm. In the scene's length unit. Positive if and only if a state is valid, and 1e-12 where nothing more is
        proved. Shapes as of is_valid."""
    def check_motions(self, starts: ArrayLike, ends: ArrayLike) -> NDArray[np.bool_]:
        """Which motions are valid, from each row of starts to that of ends, both of shape (n, coordinates): bools of
        shape (n,). The starts must be valid, as in OMPL."""
    def find_blocked(self, path: ArrayLike) -> NDArray[np.int64]:
        """Which motions of a path, with a state in each row, are blocked, or begin or end in a state that is: numbers i
        of motions from row i to row i + 1, of shape (n,), none if the path is free. Of a path of one state, 0. All of
        it is checked among the same obstacles: changes by other threads wait for it, and so does Ctrl-C."""
    def distance(self, starts: ArrayLike, ends: ArrayLike) -> Any:
        """How far each end is from its start, in the team's own distance, for planners of your own: what plan() counts
        as length, whatever is in between. For arrays of shape (n, coordinates) an array of shape (n,), for two states a
        float. One state serves for many. NaN where a number is not finite."""
    def interpolate(self, starts: ArrayLike, ends: ArrayLike, t: ArrayLike) -> NDArray[np.float64]:
        """States on the motions from starts to ends that check_motions looks at: t, a number or an array of shape (n,),
        is how much of the way they are, from 0 to 1. Of shape (n, coordinates), or (coordinates,) for two states and
        one number. One state, or one number, serves for many. Rows of NaN where a number is not finite."""
    def describe_collision(self, state: ArrayLike) -> str:
        """What collides in a state, in one line that names the obstacle and the link; empty if it is valid. Obstacles
        of the scene are called as Scene.validate() calls them, others added obstacle 3, added cloud 1, added grid 2 or
        added map 3, by their numbers. Of a collision each call takes time in proportion to all obstacles, so ask
        is_valid() about many states."""
    def prove(self, path: ArrayLike) -> Proof:
        """Prove that no robot touches anything on a path of your own, of shape (n, coordinates), also between its
        states, as Plan.prove() does for a plan's. Its ends are looked at, too, but no bounds: see
        Scene.state_bounds."""
    def add_obstacle(self, body: Body, pose: Optional[ArrayLike] = None) -> int:
        """Add an obstacle and return its number."""
    def move_obstacle(self, obstacle: Whole, pose: Optional[ArrayLike]) -> None:
        """Move an obstacle. The scene's own have the numbers that Scene.add_obstacle returned."""
    def remove_obstacle(self, obstacle: Whole) -> None:
        """Remove an obstacle."""
    def change_obstacles(
        self,
        *,
        add: Sequence[Tuple[Body, Optional[ArrayLike]]] = (),
        move: Mapping[Any, ArrayLike] = {},
        remove: Union[Sequence[Whole], NDArray[Any]] = (),
    ) -> List[int]:
        """Change many obstacles, all at once: remove those of some numbers, move others to the poses of a dict from
        numbers to poses, and add pairs of a body and its pose. Returns the numbers of those that are added. Each change
        takes time in proportion to all obstacles, so one is faster than many. Where it raises an Error, nothing has
        changed."""
    def add_cloud(self, points: ArrayLike, radius: Number) -> int:
        """Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of the cloud.
        All within radius of a point is occupied. In a planar scene the same points count as of Scene.add_cloud, for the
        checker's robots."""
    def change_cloud(
        self,
        cloud: Whole,
        *,
        insert: Optional[ArrayLike] = None,
        remove: Optional[ArrayLike] = None,
        clear: Optional[Corners] = None,
    ) -> None:
        """Change a cloud, all at once: remove points of exactly these coordinates and all within the box clear = (low,
        high), which may be infinite; then insert others. The scene's own clouds have the numbers that Scene.add_cloud
        returned. Time goes with the points that come and go. Where it raises an Error, nothing has changed. Points have
        the cloud's radius, and the shapes of add_cloud: in a planar scene those of shape (n, 3) that no robot reaches
        do not count, in insert and in remove."""
    def remove_cloud(self, cloud: Whole) -> None:
        """Remove a cloud. No other one gets its number."""
    def cloud_points(self, cloud: Whole) -> NDArray[np.float64]:
        """The points of a cloud now, of shape (n, dimension), in no order"""
    def add_grid(self, occupied: ArrayLike, size: Number, first: ArrayLike = (), origin: ArrayLike = ()) -> int:
        """Add obstacles that are cells of a grid, as Scene.add_grid does, and return its number."""
    def add_octomap(
        self,
        data: Union[bytes, ArrayLike],
        resolution: Number,
        binary: bool = True,
        id: str = "OcTree",
        *,
        depth: Whole = 16,
        unknown_occupied: bool = False,
        heights: Optional[Numbers] = None,
        origin: Numbers = (),
    ) -> int:
        """Add the occupied cells of an octomap, as Scene.add_octomap does, and return its number."""
    def change_octomap(
        self,
        grid: Whole,
        data: Union[bytes, ArrayLike],
        resolution: Number,
        binary: bool = True,
        id: str = "OcTree",
        *,
        depth: Whole = 16,
        unknown_occupied: bool = False,
        heights: Optional[Numbers] = None,
        origin: Numbers = (),
    ) -> None:
        """Let a map have the cells of another octomap alone, all at once: the next message of the same map. The cells
        must be as large as before, from the same origin on. From the second such change on, certificates stay where
        both are alike. Time goes with all cells of the map. Where it raises an Error, nothing has changed."""
    def remove_grid(self, grid: Whole) -> None:
        """Remove a grid or a map. No other one gets its number."""
    def grid_cells(self, grid: Whole) -> NDArray[np.int64]:
        """The occupied cells of a grid or a map now: their indices, of shape (n, dimension), in no order. Cell (i, j)
        of a map begins at (i, j) times its resolution, from its origin on."""
    def change_grid(self, grid: Whole, occupied: ArrayLike, first: ArrayLike = ()) -> None:
        """Set which cells of a grid are occupied, all at once: those that the array covers, whose first one has the
        index first. Others stay. The scene's own grids and maps have the numbers that Scene.add_grid and the like
        returned. Cells are those of the map itself, whatever depth it was loaded with. Time goes with the cells that
        the array covers, and with the blocks of 16 cells a side of the whole map; at the first change of a map with all
        of its cells. Where it raises an Error, nothing has changed."""
    def without_robots(
        self, points: ArrayLike, state: ArrayLike, *, padding: Number = 0.0
    ) -> NDArray[np.float64]:
        """Those of the points, of the shapes of add_cloud, that are no part of the team where it was when a sensor saw
        them. In a planar scene points are looked at as seen from above. Leaves out points inside a robot's body or
        nearer to it than padding: the radius of the cloud, and the errors of the sensor and of the state. What the body
        itself keeps as its padding is added: an obstacle within it is left out, too. Also rows that are not finite,
        where a sensor saw nothing."""
    def find_robots(self, points: ArrayLike, state: ArrayLike, *, padding: Number = 0.0) -> NDArray[np.bool_]:
        """Which of the points are part of the team, as without_robots tells: bools of shape (n,), a mask for colors and
        intensities. Rows that are not finite are none."""
    def certificates(self) -> NDArray[np.float64]:
        """The certificates of the obstacles: an array of shape (n, dimension + 1), in each row a point and its
        clearance"""
    def save_certificates(self, file: Path) -> None:
        """Write what is known of the obstacles to a file."""
    def load_certificates(self, file: Path) -> int:
        """Read what another run knew of the same obstacles, and return the number of certificates."""
    def statistics(self) -> Dict[str, Union[int, float]]:
        """How checks were settled so far, as in the report of a plan"""
    def reset_statistics(self) -> None:
        """Set all counts to 0."""
    def set_max_certificates(self, most: Optional[Whole]) -> None:
        """Keep at most so many certificates, of obstacles and of pairs of robots together, or as many as come up (None,
        the default). At the limit none are added. A world that changes for hours needs one: each change looks at the
        certificates near it."""
    def clear_certificates(self) -> None:
        """Forget all certificates. Waits for running checks of other threads."""
    def set_adaptive(self, adaptive: bool) -> None:
        """Whether to skip certificates where they have not paid lately (the default). If not, counts depend only on the
        states, for experiments. Not while others use the checker."""

class Proof:
    """What is known of a path between the states at which it was checked"""
    @property
    def proved(self) -> bool:
        """Whether all of the path is proved free"""
    @property
    def unproved(self) -> List[int]:
        """The motions that are not proved free, each by the row of the path that it starts at"""
    @property
    def collision(self) -> Optional[NDArray[np.float64]]:
        """The first invalid state that was found on these motions, of shape (coordinates,); None if none was"""
    @property
    def reason(self) -> Optional[str]:
        """What collides there, in a few words; None if nothing was found"""
    def __bool__(self) -> bool: ...

class PassingOrder:
    """Which robot passes first wherever the ways of two robots of a plan cross, for robots that may be late. The plan
    is cut into stages in time. Each robot drives its stages one after the other at its own pace, and begins one only
    when may_begin() says so; the robots of a group() drive that stage together, by one clock. Then no two robots touch,
    and none waits forever."""
    @property
    def times(self) -> NDArray[np.float64]:
        """When the stages begin and end in the plan, of shape (stages + 1,): stage i is from times[i] to times[i +
        1]"""
    @property
    def waits(self) -> NDArray[np.int64]:
        """What robots wait for, of shape (n, 4): robot, stage, other, other_stage. The robot begins that stage only
        after the other one has ended its other_stage. By robots and then by stages; what earlier waits imply is left
        out."""
    @property
    def meetings(self) -> NDArray[np.int64]:
        """Which robots drive which stages together, by one clock, as the plan does, since they are too close to each
        other there, of shape (m, 3): first, second, stage. They wait for each other before it. Smaller stages leave
        fewer."""
    def group(self, robot: Whole, stage: Whole) -> List[int]:
        """The robots that drive a stage together with a robot, and itself, by their indices in the scene"""
    def may_begin(self, robot: Whole, ended: Union[Sequence[Whole], NDArray[Any]]) -> bool:
        """Whether a robot, by its index in the scene, and all others of its group() may begin their next stage, if each
        robot has ended that many stages. False if it has ended all."""

class Plan:
    """What came of a plan"""
    @property
    def solved(self) -> bool:
        """Whether a solution was found"""
    @property
    def reason(self) -> Optional[str]:
        """Why there is no solution, in a few words; None if there is one"""
    @property
    def cost(self) -> float:
        """The cost of the path, by the objective; infinite without a solution"""
    @property
    def path(self) -> NDArray[np.float64]:
        """The states of the solution, of shape (n, coordinates); n is 0 without"""
    @property
    def times(self) -> NDArray[np.float64]:
        """When the team is at each state if no robot is faster than its speed, of shape (n,)"""
    @property
    def coordinates(self) -> List[str]:
        """The names of the columns of path, such as scout.x"""
    @property
    def report(self) -> Dict[str, Any]:
        """Costs, counts and times (docs/plan-team.md), as a dict. The first report, page or picture of the tree copies
        the planner's tree: some seconds for a hundred thousand states. The first report or page of a solution also
        calls prove(), unless that was done before."""
    def prove(self) -> Proof:
        """Prove that no robot touches anything on the path, also between the samples that discrete mode looks at, among
        the checker's obstacles as they are now. Where a motion is not proved, samples a hundred times as dense are
        looked at until one collides. Raises Error if there is no path."""
    def passing_order(self, step: Number) -> PassingOrder:
        """Which robot passes first wherever the ways of two robots cross, for robots that may be late, in stages of at
        most so much time. Raises Error if there is no path, or step is not positive."""
    def save(self, file: Path, *, step: Optional[Number] = None) -> None:
        """Write the path as a table of comma-separated values (docs/plan-team.md). With a step there is a line at each
        multiple of it in time, too, such as the period of a controller."""
    def save_report(self, file: Path) -> None:
        """Write the report as JSON."""
    def at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Where the team is at some times, of shape (n, coordinates), or for one time (coordinates,). Between two
        states of the path all robots move steadily, as OMPL interpolates; before the first and after the last they
        rest."""
    def save_picture(self, file: Path, *, tree: bool = False, certificates: bool = False) -> None:
        """Write a picture of the scene and the path, as SVG; with the planner's tree and the certificates if asked. The
        name must end in .svg."""
    def save_animation(self, file: Path) -> None:
        """Write a picture in which the robots follow the path again and again, as SVG, which browsers play. The name
        must end in .svg. Raises Error if there is no path."""
    def view(self, path: Optional[Path] = None) -> View:
        """A page in which the plan can be looked at, which a notebook shows. With a path it is written to that file,
        too."""
    def __bool__(self) -> bool: ...

class ControlPlan:
    """What came of a plan by controls"""
    @property
    def solved(self) -> bool:
        """Whether a solution was found"""
    @property
    def reason(self) -> Optional[str]:
        """Why there is no solution, in a few words; None if there is one"""
    @property
    def cost(self) -> float:
        """The duration of the path, in seconds; infinite without a solution"""
    @property
    def path(self) -> NDArray[np.float64]:
        """The states of the solution, one for each step, of shape (n, coordinates); n is 0 without"""
    @property
    def times(self) -> NDArray[np.float64]:
        """When the team is at each state, in seconds, of shape (n,)"""
    @property
    def coordinates(self) -> List[str]:
        """The names of the columns of path, such as scout.x"""
    @property
    def controls(self) -> NDArray[np.float64]:
        """The controls that are held from each state to the next, of shape (n - 1, controls)"""
    @property
    def control_names(self) -> List[str]:
        """The names of the columns of controls, such as cart.linear"""
    @property
    def report(self) -> Dict[str, Any]:
        """Costs, counts and times (docs/plan-team.md), as a dict. The first report, page or picture of the tree copies
        the planner's tree: some seconds for a hundred thousand states. The first report or page of a solution also
        calls prove(), unless that was done before."""
    def prove(self, checker: Optional[Checker] = None) -> Proof:
        """Prove that no robot touches anything on the path, also within its steps, at whose ends alone discrete mode
        looks: among the obstacles that the scene had when the plan was made, or those that a checker has now: the one
        that is passed, such as one of the same scene that is told what a sensor sees, or that the plan was made with.
        In a step that is not proved a hundred states are looked at until one collides. Raises Error if there is no
        path."""
    def save(self, file: Path) -> None:
        """Write times, states and controls as a table of comma-separated values (docs/controls.md)."""
    def save_report(self, file: Path) -> None:
        """Write the report as JSON."""
    def at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Where the team is at some times, in seconds, of shape (n, coordinates), or for one time (coordinates,).
        Between two states of the path it moves as the controls move it; before the first and after the last it
        rests."""
    def save_picture(self, file: Path, *, tree: bool = False, certificates: bool = False) -> None:
        """Write a picture of the scene and the path, as SVG; with the planner's tree and the certificates if asked. The
        name must end in .svg."""
    def save_animation(self, file: Path) -> None:
        """Write a picture in which the robots follow the path again and again, as SVG, which browsers play. The name
        must end in .svg. Raises Error if there is no path."""
    def view(self, path: Optional[Path] = None) -> View:
        """A page in which the plan can be looked at, which a notebook shows. With a path it is written to that file,
        too."""
    def __bool__(self) -> bool: ...

def load_scene(file: Path, *, dynamics: bool = False) -> Scene:
    """The scene in a YAML file (docs/scene-format.md) or a .cfg file of OMPL.app. With dynamics robots of db-CBS move
    by controls, and their velocities count; there may be no others."""
def scene_from_yaml(text: str, source: str = "scene.yaml", *, dynamics: bool = False) -> Scene:
    """The scene in a text, as load_scene() reads it. Errors name source, and meshes are looked for in its folder."""
def load_cloud(file: Path) -> NDArray[np.float64]:
    """The points of a PCD or PLY file, or of a text (.xyz, .txt, .asc, .pts or .csv), of shape (n, 3), without those
    that are not finite: to be moved, scaled and cut by numpy, for add_cloud and change_cloud."""
def load_moveit(scene: Path, request: Path, urdf: Path, srdf: Path, packages: Mapping[str, Path] = ...) -> Scene:
    """The scene in MoveIt's planning scene and motion plan request (YAML). packages are as for Robot.arm()."""
def planner_parameters(planner: str) -> Dict[str, Tuple[str, str]]:
    """The parameters of a planner: a dict from their names to their values and the ranges that OMPL suggests, as texts
    such as 0.:1.:10000., which is from 0 in steps of 1 to 10000"""
def planner_names() -> List[str]:
    """The names of all planners: OMPL's classes, and DRRTstar"""
def _plan(
    checker: Checker,
    planner: str,
    time: Number,
    iterations: Whole,
    seed: Whole,
    callback: Optional[Callable[[float, float], object]],
    objective: str,
    first: bool,
    simplify: bool,
    parameters: Mapping[str, Any],
    start: Optional[ArrayLike],
    goal: Union[ArrayLike, AnyOf, LinkPose, Zone, Mapping[str, Union[ArrayLike, AnyOf, LinkPose, Zone]], None],
) -> Plan: ...
def control_planner_names() -> List[str]:
    """The names of the planners of plan_controls()"""
def control_planner_parameters(planner: str) -> Dict[str, Tuple[str, str]]:
    """The parameters of a planner of plan_controls(), as planner_parameters() tells them"""
def _plan_controls(
    scene: Optional[Scene],
    checker: Optional[Checker],
    planner: str,
    method: str,
    time: Number,
    iterations: Whole,
    seed: Whole,
    callback: Optional[Callable[[float, float], object]],
    motion: str,
    goal_tolerance: Number,
    nearest: str,
    parameters: Mapping[str, Any],
    start: Optional[ArrayLike],
    goal: Optional[ArrayLike],
    step: Number,
    min_steps: Whole,
    max_steps: Whole,
    simplify: bool,
) -> ControlPlan: ...
