// Builds dist/viewer.html, the page without a plan: all scripts and styles in one file, minified, with three's license.
// With --check it only tells whether the file is what the sources give.
import { readFileSync, writeFileSync } from 'node:fs'
import { buildSync } from 'esbuild'

const here = (path) => new URL(path, import.meta.url).pathname
const target = here('dist/viewer.html')
const bundle = (entry, loader) =>
  buildSync({ entryPoints: [here(entry)], bundle: true, minify: true, write: false, target: 'es2022', loader, legalComments: 'none', charset: 'utf8' })
    .outputFiles[0].text.trim()

const license = readFileSync(here('node_modules/three/LICENSE'), 'utf8').trim()
const { version } = JSON.parse(readFileSync(here('node_modules/three/package.json'), 'utf8'))
const script = `/*!\nContains three.js ${version}:\n\n${license}\n*/\n${bundle('src/main.js')}`
const page = readFileSync(here('src/page.html'), 'utf8')
  .replace('/*STYLE*/', () => bundle('src/page.css'))
  .replace('/*SCRIPT*/', () => script)

if (process.argv.includes('--check')) {
  if (readFileSync(target, 'utf8') !== page) {
    console.error('viewer/dist/viewer.html is not what viewer/src gives: run scripts/viewer.sh')
    process.exit(1)
  }
  console.log('viewer/dist/viewer.html is what viewer/src gives')
} else {
  writeFileSync(target, page)
  console.log(`viewer/dist/viewer.html: ${(page.length / 1e6).toFixed(2)} MB`)
}
