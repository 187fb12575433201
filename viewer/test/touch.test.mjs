// Fingers on the canvas, as a phone reports them.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launch, open, plan } from './support.mjs'

const PHONE = { width: 390, height: 844 }
const STEPS = 8

let browser
before(async () => (browser = await launch()))
after(() => browser?.close())

/** Move fingers at the same time: for each from where to where on the canvas, in parts of its width and height */
async function drag(page, ...fingers) {
  const { x, y, width, height } = await page.locator('#canvas canvas').boundingBox()
  const session = await page.context().newCDPSession(page)
  const touch = (type, touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints })
  const pointsAt = (fraction) =>
    fingers.map(([from, to], id) => ({
      id,
      x: x + width * (from[0] + fraction * (to[0] - from[0])),
      y: y + height * (from[1] + fraction * (to[1] - from[1])),
    }))
  await touch('touchStart', pointsAt(0))
  for (let i = 1; i <= STEPS; ++i) await touch('touchMove', pointsAt(i / STEPS))
  await touch('touchEnd', [])
  await session.detach()
}

/** Where the camera is, what it looks at, and what point of the floor, or of its height there, is at a place of the canvas */
const seen = (page, place = [0.5, 0.5]) =>
  page.evaluate(([right, down]) => {
    const { camera, target } = viewer
    camera.updateMatrixWorld()
    const offset = camera.position.clone().sub(target)
    const point = camera.position.clone().set(2 * right - 1, 1 - 2 * down, 0).unproject(camera)
    return {
      direction: offset.clone().normalize().toArray(),
      distance: offset.length(),
      target: target.toArray(),
      zoom: camera.zoom,
      point: point.toArray().slice(0, 2),
    }
  }, place)

const apart = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]))

test('fingers turn, move and zoom a scene of space', async () => {
  const { page, troubles, close } = await open(browser, plan('drones_3d.yaml', '--iterations', '1000').page, PHONE, true)
  const first = await seen(page)
  await drag(page, [[0.3, 0.5], [0.6, 0.6]])
  const turned = await seen(page)
  assert.ok(apart(first.direction, turned.direction) > 0.3, 'one finger turns')
  assert.ok(apart(first.target, turned.target) < 1e-6 * first.distance, 'about the same point')
  assert.ok(Math.abs(turned.distance / first.distance - 1) < 1e-6, 'at the same distance')

  await drag(page, [[0.4, 0.5], [0.3, 0.5]], [[0.6, 0.5], [0.7, 0.5]])
  const near = await seen(page)
  assert.ok(Math.abs(turned.distance / near.distance - 2) < 0.02, `twice as near: ${turned.distance / near.distance}`)
  assert.ok(apart(turned.direction, near.direction) < 1e-3, 'two fingers do not turn')

  await drag(page, [[0.3, 0.4], [0.3, 0.6]], [[0.6, 0.4], [0.6, 0.6]])
  const moved = await seen(page)
  assert.ok(apart(near.target, moved.target) > 0.05 * near.distance, 'two fingers move')
  assert.ok(Math.abs(moved.distance / near.distance - 1) < 1e-3, 'at the same distance')
  assert.ok(apart(near.direction, moved.direction) < 1e-3, 'without turning')
  assert.deepEqual(troubles, [])
  await close()
})

test('fingers move and zoom a scene of the plane', async () => {
  const { page, troubles, close } = await open(browser, plan('paper_five_discs.yaml', '--iterations', '100').page, PHONE, true)
  const extent = await page.evaluate('viewer.plan.extent')
  const assertFollows = async (from, to, what) => {
    const there = await seen(page, to)
    assert.ok(apart(from, there.point) < 0.01 * extent, `${what}: ${from} is at ${there.point}`)
    assert.deepEqual(there.direction.map(Math.round), [0, 0, 1], 'it does not turn')
    return there
  }
  const { point } = await seen(page, [0.3, 0.4])
  await drag(page, [[0.3, 0.4], [0.6, 0.7]])
  const moved = await assertFollows(point, [0.6, 0.7], 'what was under the finger stays there')
  assert.equal(moved.zoom, 1)

  const { point: middle } = await seen(page, [0.4, 0.5])
  await drag(page, [[0.3, 0.5], [0.2, 0.5]], [[0.5, 0.5], [0.6, 0.5]])
  const near = await assertFollows(middle, [0.4, 0.5], 'what was between the fingers stays there')
  assert.ok(Math.abs(near.zoom - 2) < 0.02, `twice as large: ${near.zoom}`)

  await page.locator('#play').tap()
  await page.waitForFunction('viewer.frame > 0')
  assert.deepEqual(troubles, [])
  await close()
})
