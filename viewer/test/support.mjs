// Plans, their files, and a browser without a network.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { chromium } from 'playwright-core'

export const scenes = new URL('../../demos/scenes/', import.meta.url).pathname

/** The states of a path's file: for each an object from the names of the columns to numbers */
export function readPath(file) {
  const [names, ...lines] = readFileSync(file, 'utf8')
    .trim()
    .split('\n')
    .map((line) => line.split(','))
  return lines.map((line) => Object.fromEntries(line.map((text, i) => [names[i], Number(text)])))
}

const folder = mkdtempSync(join(tmpdir(), 'viewer-'))

/** Plan for a scene with seed 1 (with --iterations, so that a slow machine finds the same), and return the page, the states of the path and the report */
export function plan(scene, ...options) {
  const file = (ending) => join(folder, `${scene.replaceAll('/', '_')}.${ending}`)
  execFileSync(process.env.CERTIFICATES, ['plan', join(scenes, scene), '--quiet', '--seed', '1', '--view', file('html'), '--path', file('csv'), '--report', file('json'), ...options])
  return { page: file('html'), size: readFileSync(file('html')).length, states: readPath(file('csv')), report: JSON.parse(readFileSync(file('json'), 'utf8')) }
}

export function launch(...options) {
  return chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--use-gl=angle', '--use-angle=swiftshader', '--no-sandbox', ...options] })
}

/** Open a page without a network. What goes wrong in it, and what it asks for beside its file, is in `troubles`. */
export async function open(browser, file, viewport = { width: 900, height: 560 }, hasTouch = false) {
  const context = await browser.newContext({ viewport, hasTouch, offline: true })
  const page = await context.newPage()
  const troubles = []
  page.on('pageerror', (error) => troubles.push(String(error)))
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver Message/.test(message.text()) && troubles.push(message.text()))
  page.on('request', (request) => request.url() !== `file://${file}` && !/^(data|blob):/.test(request.url()) && troubles.push(request.url()))
  await page.goto(`file://${file}`)
  await page.waitForSelector('body.ready')
  return { page, troubles, close: () => context.close() }
}

/** The pixels of the canvas: width, height, and rgba bytes */
export async function pixels(page) {
  await page.evaluate(() => new Promise((done) => {
    viewer.draw()
    requestAnimationFrame(() => requestAnimationFrame(done))
  }))
  const png = await page.locator('#canvas canvas').screenshot()
  const { width, height, data } = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d')
    context.drawImage(image, 0, 0)
    let data = ''
    for (const byte of context.getImageData(0, 0, image.width, image.height).data) data += String.fromCharCode(byte)
    return { width: image.width, height: image.height, data: btoa(data) }
  }, png.toString('base64'))
  return { width, height, data: Buffer.from(data, 'base64') }
}

/** The mean color of the pixels that differ by `least` or more, and how many there are */
export function difference(a, b, least = 24) {
  const sum = [0, 0, 0]
  let count = 0
  for (let i = 0; i < a.data.length; i += 4) {
    if (Math.max(...[0, 1, 2].map((c) => Math.abs(a.data[i + c] - b.data[i + c]))) < least) continue
    ++count
    for (let c = 0; c < 3; ++c) sum[c] += a.data[i + c]
  }
  return { count, color: sum.map((value) => value / Math.max(count, 1)) }
}

/** The hue of a color of 0 to 255, in degrees */
export function hue([r, g, b]) {
  const max = Math.max(r, g, b)
  const span = max - Math.min(r, g, b)
  const part = max === r ? ((g - b) / span + 6) % 6 : max === g ? (b - r) / span + 2 : (r - g) / span + 4
  return 60 * part
}
