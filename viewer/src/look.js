// Colors of the page's light and dark look, and the order in which things of the plane cover each other.

const LIGHT = {
  background: '#f3f4f1',
  floor: '#ffffff',
  grid: '#d9dbd5',
  frame: '#8b8f88',
  obstacle: '#b9bbb6',
  edge: '#55585a',
  certificate: '#9a9a2e',
}
const DARK = {
  background: '#15181c',
  floor: '#1d2126',
  grid: '#30363d',
  frame: '#6d747c',
  obstacle: '#6b7178',
  edge: '#a3aab2',
  certificate: '#d6d65c',
}

export const isDark = () => matchMedia('(prefers-color-scheme: dark)').matches
export const look = isDark() ? DARK : LIGHT

export const ORDER = { floor: 0, grid: 1, certificates: 2, obstacles: 3, zones: 4, tree: 5, trail: 6, path: 7, goal: 8, robot: 9 }

/** What a material needs in a flat scene: all of it is drawn in the order above. */
export const FLAT = { depthTest: false, depthWrite: false, transparent: true }
