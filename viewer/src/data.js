// The plan that the page holds, as PlanViewer::toJson() writes it. Arrays of numbers are little-endian, in base64.
//
//   name, dimension (2 or 3), end (the time of the last pose), report (a PlanReport, or null)
//   bounds        low, high, and origin: all positions below are relative to it
//   shapes        kind: ball (radius), box (size), capsule and cylinder (radius, length; along z), polygon (points: x, y,
//                 ...), mesh (low, step, vertices: 16 bits each, triangles: indices of indexBytes bytes)
//   obstacles     shape (an index), poses (floats)
//   cells         edge (their length), origin (of cell 0, from that of the bounds), low and size (16 bits, in cells)
//   clouds        points (floats) of nearly equal radii, radius (the largest of these)
//   robots        name, color, bodies (for each its parts: [shape, pose]), traced (an index of a body), times (floats,
//                 of the keys), poses (floats: for each key those of all bodies), goal (floats: those of all bodies),
//                 links (of an arm: their names, for each body), zones (that it keeps out of: [shape, pose]), tree
//                 (low, step, points: 16 bits each; two points are a line)
//   certificates  floats: x, y, z, radius
//
// A pose is seven numbers: the position and the quaternion x, y, z, w.

export const POSE = 7

function bytesOf(base64) {
  const text = atob(base64)
  const bytes = new Uint8Array(text.length)
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i)
  return bytes.buffer
}

export const floats = (base64) => new Float32Array(bytesOf(base64))
export const words = (base64) => new Uint16Array(bytesOf(base64))
export const signedWords = (base64) => new Int16Array(bytesOf(base64))

/** Indices of two or four bytes */
export const indices = (base64, size) =>
  size === 2 ? new Uint16Array(bytesOf(base64)) : new Uint32Array(bytesOf(base64))

/** Points of 16 bits as floats */
export function unquantized({ low, step }, coordinates) {
  const points = new Float32Array(coordinates.length)
  for (let i = 0; i < points.length; ++i) points[i] = low[i % 3] + coordinates[i] * step[i % 3]
  return points
}

/** The plan, with its arrays unpacked */
export function readPlan(text) {
  const plan = JSON.parse(text)
  for (const robot of plan.robots) {
    robot.times = floats(robot.times)
    robot.poses = floats(robot.poses)
    robot.goal = floats(robot.goal)
    robot.tree = robot.tree ? unquantized(robot.tree, words(robot.tree.points)) : new Float32Array()
  }
  for (const obstacle of plan.obstacles) obstacle.poses = floats(obstacle.poses)
  for (const cells of plan.cells) {
    cells.low = signedWords(cells.low)
    cells.size = words(cells.size)
  }
  for (const cloud of plan.clouds) cloud.points = floats(cloud.points)
  plan.certificates = floats(plan.certificates)
  const { low, high, origin } = plan.bounds
  // The box of the workspace around its middle; flat in the plane
  const relative = (corner) => [0, 1, 2].map((axis) => (corner[axis] ?? 0) - origin[axis])
  plan.low = relative(low)
  plan.high = relative(high)
  plan.extent = Math.max(...plan.high.map((value, axis) => value - plan.low[axis]))
  plan.spatial = plan.dimension === 3
  return plan
}
