// Opens plans in a browser without a network, and compares what is shown with their files.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { Matrix4, Quaternion, Vector3 } from 'three'
import { forwardKinematics } from './arm.mjs'
import { difference, hue, launch, open, pixels, plan, scenes } from './support.mjs'

let browser
before(async () => (browser = await launch()))
after(() => browser?.close())

/** Poses in the plane and in space, from the columns of a path's file */
const planar = (state, robot) => [
  [state[`${robot}.x`], state[`${robot}.y`], 0, 0, 0, Math.sin((state[`${robot}.yaw`] ?? 0) / 2), Math.cos((state[`${robot}.yaw`] ?? 0) / 2)],
]
const spatial = (state, robot) => [['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw'].map((name) => state[`${robot}.${name}`] ?? (name === 'qw' ? 1 : 0))]

/** The page says where bodies are to a ten-thousandth of the scene's extent, and 0.005 radians. */
function assertSamePoses(actual, expected, extent, what) {
  assert.equal(actual.length, expected.length, what)
  expected.forEach((pose, i) => {
    const distance = Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - actual[i][axis]))
    assert.ok(distance <= 1.2e-4 * extent, `${what}, body ${i}: ${distance} away`)
    const angle = new Quaternion(...pose.slice(3)).angleTo(new Quaternion(...actual[i].slice(3)))
    assert.ok(angle <= 0.006, `${what}, body ${i}: turned by ${angle}`)
  })
}

async function assertShowsPath({ page, troubles }, { states, report }, posesOf) {
  const robots = await page.evaluate('viewer.robots')
  const extent = await page.evaluate('viewer.plan.extent')
  assert.equal(await page.evaluate('viewer.plan.report.tree.digest'), report.tree.digest)
  assert.ok(Math.abs((await page.evaluate('viewer.plan.end')) - states.at(-1).time) < 1e-6 * states.at(-1).time)
  const poses = await page.evaluate((times) => times.map((time) => viewer.posesAt(time)), states.map(({ time }) => time))
  states.forEach((state, k) => robots.forEach((robot, i) => assertSamePoses(poses[k][i], posesOf(state, robot), extent, `${robot} at state ${k}`)))

  // What is drawn, at both ends
  for (const [frame, state] of [['0', states[0]], ['viewer.frames - 1', states.at(-1)]]) {
    await page.evaluate(`viewer.frame = ${frame}`)
    const shown = await page.evaluate('viewer.shownPoses()')
    robots.forEach((robot, i) => assertSamePoses(shown[i], posesOf(state, robot), extent, `${robot} at frame ${frame}`))
  }
  assert.deepEqual(troubles, [])
}

/** Hiding a robot changes pixels, and what was there had its color. */
async function assertRobotsAreSeen({ page, troubles }, most) {
  await page.evaluate(`for (const layer of Object.keys(viewer.layers())) viewer.setLayer(layer, false)`)
  const all = await pixels(page)
  assert.ok(new Set(new Uint32Array(all.data.buffer, all.data.byteOffset, all.data.length / 4)).size > 20, 'many colors')
  const colors = await page.evaluate('viewer.plan.robots.map(({ color }) => color)')
  for (const [i, color] of colors.slice(0, most).entries()) {
    await page.evaluate((robot) => viewer.setRobot(robot, { visible: false }), i)
    const changed = difference(all, await pixels(page))
    await page.evaluate((robot) => viewer.setRobot(robot, { visible: true }), i)
    assert.ok(changed.count > 20, `robot ${i}: ${changed.count} pixels`)
    const expected = hue([1, 3, 5].map((digit) => parseInt(color.slice(digit, digit + 2), 16)))
    const apart = Math.abs(((hue(changed.color) - expected + 540) % 360) - 180)
    assert.ok(apart < 25, `robot ${i} is ${color}, and has been seen as ${changed.color}`)
  }
  assert.deepEqual(troubles, [])
}

test('drones in space', async () => {
  const made = plan('drones_3d.yaml', '--iterations', '1000')
  const opened = await open(browser, made.page)
  await assertShowsPath(opened, made, spatial)
  await assertRobotsAreSeen(opened, 4)
  await opened.close()
})

test('sixteen discs and boxes', async () => {
  const made = plan('teams/boxes_16.yaml', '--iterations', '1000')
  const opened = await open(browser, made.page)
  await assertShowsPath(opened, made, planar)
  await assertRobotsAreSeen(opened, 4)
  await opened.close()
})

test('arms', async () => {
  const made = plan('arms/two_arms.yaml', '--iterations', '1000')
  assert.ok(made.size < 2e6, `${made.size} bytes`)
  const opened = await open(browser, made.page)
  // As two_arms.yaml has them
  const held = { name: 'bar', type: 'fixed', parent: 'palm', child: 'bar', origin: new Matrix4().setPosition(0, 0, 0.11) }
  const shapeOf = forwardKinematics(`${scenes}arms/arm6.urdf`, [held])
  const bases = {
    left: new Matrix4().setPosition(-0.55, 0, 0.401),
    right: new Matrix4().makeRotationZ(3.1416).setPosition(0.55, 0, 0.401),
  }
  const gripper = { right: { finger: 0.035, other_finger: 0.035 } }
  const arms = Object.fromEntries(await opened.page.evaluate('viewer.plan.robots.map(({ name, links, bodies }) => [name, { links, bodies }])'))
  await assertShowsPath(opened, made, (state, robot) => {
    const { links, bodies } = arms[robot]
    if (!links) return spatial(state, robot)
    // left.joints.waist, left.flange.yaw: the coordinates of joints with and without limits
    const own = Object.entries(state).filter(([name]) => name.startsWith(`${robot}.`))
    const joints = own.map(([name, value]) => [name.split('.').filter((part) => part !== 'joints')[1], value])
    return links.map((link, i) => {
      const [shape] = bodies[i][0].slice(1)
      const inBody = new Matrix4().compose(new Vector3(...shape), new Quaternion(...shape.slice(3)), new Vector3(1, 1, 1))
      const pose = shapeOf(link, bases[robot], { ...Object.fromEntries(joints), ...gripper[robot] }).multiply(inBody.invert())
      const [position, turn] = [new Vector3(), new Quaternion()]
      pose.decompose(position, turn, new Vector3())
      return [...position, ...turn]
    })
  })
  await assertRobotsAreSeen(opened, 3)
  await opened.close()
})

for (const [world, scene, numbers, least] of [
  ['an octomap', 'drones_octomap.yaml', 'cells[0].low', 300],
  ['a point cloud', 'cloud.yaml', 'clouds[0].points', 3000],
])
  test(`drones in ${world}`, async () => {
    const made = plan(scene, '--iterations', '1000')
    const opened = await open(browser, made.page)
    await assertShowsPath(opened, made, spatial)
    assert.ok((await opened.page.evaluate(`viewer.plan.${numbers}.length`)) > least)
    await assertRobotsAreSeen(opened, 2)
    await opened.close()
  })

test('robots that move by controls', async () => {
  const made = plan('controls/doorway.yaml', '--dynamics', '--iterations', '20000')
  const opened = await open(browser, made.page)
  // cart.x, but puck.pose.x, beside its velocity
  await assertShowsPath(opened, made, (state, robot) => planar(state, `${robot}.x` in state ? robot : `${robot}.pose`))
  await assertRobotsAreSeen(opened, 2)
  await opened.close()
})

test('keys and controls, on a phone', async () => {
  const made = plan('paper_five_discs.yaml', '--iterations', '1000')
  const { page, troubles, close } = await open(browser, made.page, { width: 390, height: 844 })
  const state = (expression) => page.evaluate(`viewer.${expression}`)
  const width = await page.evaluate('document.documentElement.scrollWidth')
  assert.ok(width <= 390, `nothing sticks out: ${width}`)
  assert.ok((await page.locator('#panel').boundingBox()).y > (await page.locator('#canvas').boundingBox()).height, 'the panel is below')

  await page.locator('#speed').selectOption('4')
  await page.keyboard.press('Space')
  assert.equal(await state('playing'), true)
  await page.waitForFunction('viewer.frame === viewer.frames - 1 && !viewer.playing')
  await page.keyboard.press('Home')
  assert.equal(await state('frame'), 0)
  await page.keyboard.press('ArrowRight')
  assert.equal(await state('frame'), 3)

  // Pausing does not leave another playback behind.
  const pace = await page.evaluate(async () => {
    for (let i = 0; i < 3; ++i) {
      viewer.play()
      viewer.pause()
    }
    const begin = performance.now()
    const from = viewer.frame
    viewer.play()
    // On a busy machine the first frame may take longer.
    do await new Promise((done) => setTimeout(done, 300))
    while (viewer.frame === from && performance.now() - begin < 20000)
    return (viewer.frame - from) / (performance.now() - begin)
  })
  assert.ok(pace > 0 && pace < 1.1 * 4 * 0.06, `${pace} frames in a millisecond at speed 4`)
  await page.locator('#scrub').fill('300')
  assert.equal(await state('frame'), 300)
  assert.equal(await state('playing'), false)

  await page.keyboard.press('2')
  assert.deepEqual(await state('visible()'), [true, false, true, true, true])
  for (const [key, layer] of [['p', 'paths'], ['t', 'tree'], ['c', 'certificates'], ['g', 'goals'], ['m', 'trail']]) {
    const [on, picture] = [await state(`layers().${layer}`), await pixels(page)]
    await page.keyboard.press(key)
    assert.equal(await state(`layers().${layer}`), !on, layer)
    assert.ok(difference(picture, await pixels(page)).count > 50, `${layer} can be seen`)
  }
  await state('camera.zoom = 3')
  await page.keyboard.press('r')
  assert.equal(await state('camera.zoom'), 1)
  assert.deepEqual(troubles, [])
  await close()
})

test('zones that robots keep out of', async () => {
  const made = plan('zones.yaml', '--iterations', '2000')
  const { page, troubles, close } = await open(browser, made.page)
  assert.deepEqual(await page.evaluate('viewer.plan.robots.map(({ zones }) => zones.length)'), [2, 2, 0, 0])
  const zone = await page.evaluate('viewer.plan.robots[0].zones[0][1]')
  const walkway = [11.75 - 10, 0, 0, 0, 0, 0, 1]
  zone.forEach((number, i) => assert.ok(Math.abs(number - walkway[i]) < 1e-6, `${zone}`))
  const shown = await pixels(page)
  await page.keyboard.press('z')
  assert.ok(difference(shown, await pixels(page), 8).count > 5000, 'zones can be seen')
  assert.deepEqual(troubles, [])
  await close()
})

test('a browser without WebGL', async () => {
  const made = plan('paper_five_discs.yaml', '--iterations', '1000')
  const plain = await launch('--disable-3d-apis')
  const page = await plain.newPage()
  await page.goto(`file://${made.page}`)
  assert.match(await page.locator('#canvas .trouble').textContent(), /needs WebGL/)
  await plain.close()
})
