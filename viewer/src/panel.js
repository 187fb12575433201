// What stands beside the canvas: robots, layers, statistics, keys.

/** An element with attributes, properties beginning with a dot, and children */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag)
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('.')) element[name.slice(1)] = value
    else if (value !== undefined) element.setAttribute(name, value)
  }
  element.append(...children)
  return element
}

const number = (value) => Number(value).toLocaleString('en-US').replaceAll(',', ' ')
const short = (value) => (value === null || value === undefined ? '–' : number(Number(value.toPrecision(4))))
const seconds = (value) => (value === null ? '–' : `${value.toFixed(value < 10 ? 3 : 1)} s`)
const share = (part, whole) => (whole > 0 ? `${((100 * part) / whole).toFixed(1)} %` : '–')

function section(title, open, ...children) {
  return make('details', { '.open': open }, make('summary', {}, title), ...children)
}

export function robotList(robots, changed) {
  const rows = robots.map((robot, i) => {
    const box = make('input', { type: 'checkbox', '.checked': true, 'aria-label': `show ${robot.name}` })
    const color = make('input', { type: 'color', '.value': `#${robot.color.getHexString()}`, 'aria-label': `color of ${robot.name}` })
    box.onchange = () => changed(i, { visible: box.checked })
    color.oninput = () => changed(i, { color: color.value })
    return { box, row: make('label', { class: 'robot' }, color, make('span', { class: 'name', title: robot.name }, robot.name), box) }
  })
  const all = make('button', { type: 'button', class: 'small' }, 'show or hide all')
  all.onclick = () => {
    const visible = !rows.some(({ box }) => box.checked)
    rows.forEach((_, i) => changed(i, { visible }))
  }
  const list = make('div', { class: 'robots' }, ...rows.map(({ row }) => row))
  return { element: section(`Robots (${robots.length})`, true, list, all), boxes: rows.map(({ box }) => box) }
}

/** @param layers for each: name, label, key, on, and slider (most, value, changed) where only some of it can be shown */
export function layerList(layers, changed) {
  const boxes = {}
  const rows = layers.map(({ name, label, key, on, slider }) => {
    boxes[name] = make('input', { type: 'checkbox', '.checked': on })
    boxes[name].onchange = () => changed(name, boxes[name].checked)
    const row = make('label', { class: 'layer' }, boxes[name], make('span', { class: 'name' }, label), make('kbd', {}, key))
    if (!slider) return row
    const range = make('input', { type: 'range', min: 1, max: slider.most, '.value': slider.value, 'aria-label': `how many ${label}` })
    const count = make('span', { class: 'count' }, `${slider.value} of ${slider.most}`)
    range.oninput = () => {
      count.textContent = `${range.value} of ${slider.most}`
      slider.changed(Number(range.value))
    }
    return make('div', {}, row, make('div', { class: 'slider' }, range, count))
  })
  return { element: section('Show', true, ...rows), boxes }
}

/** How the checks of robots' poses were settled, as a bar */
function checksBar(checks) {
  const parts = [
    ['certified free', checks.certified_free, '#009E73'],
    ['certified colliding', checks.certified_colliding, '#D55E00'],
    ['by clearances', checks.by_clearances, '#56B4E9'],
    ['by the contact test', checks.by_contact, '#E69F00'],
    ['by FCL', checks.exact, '#CC79A7'],
  ].filter(([, count]) => count > 0)
  const bar = make('div', { class: 'bar' }, ...parts.map(([label, count, color]) => make('i', { style: `flex:${count} 0 0;background:${color}`, title: label })))
  const legend = parts.map(([label, count, color]) =>
    make('div', { class: 'row' }, make('span', {}, make('b', { class: 'dot', style: `background:${color}` }), label), make('span', {}, share(count, checks.robot_poses))),
  )
  return [make('h3', {}, `${number(checks.robot_poses)} robot poses checked`), bar, ...legend]
}

function result(report) {
  if (report.solved) return `solved, cost ${short(report.simplified_cost ?? report.cost)}`
  return report.approximate ? 'approximate only' : 'not solved'
}

export function statistics(plan) {
  const { report } = plan
  if (!report) return section('Statistics', true, make('p', {}, 'No plan'))
  const { checks } = report
  const rows = [
    ['Result', result(report)],
    ...(report.simplified_cost === null ? [] : [['Cost before it was simplified', short(report.cost)]]),
    ['Planner', report.planner],
    ['Method', `${report.method}, ${report.motion}`],
    ['Objective', report.objective],
    ['Seed', String(report.seed)],
    ...(report.seconds.first_solution === null ? [] : [['First solution after', seconds(report.seconds.first_solution)]]),
    ['Time to plan', seconds(report.seconds.total)],
    ['In checks', `${seconds(report.seconds.checking)} (${share(report.seconds.checking, report.seconds.total)})`],
    ['Tree', `${number(report.tree.states)} state${report.tree.states === 1 ? '' : 's'}`],
    ['Certificates', number(checks.certificates)],
    ['Calls of FCL', number(checks.exact_calls + checks.pair_exact)],
  ]
  return section(
    'Statistics',
    true,
    ...rows.map(([label, value]) => make('div', { class: 'row' }, make('span', {}, label), make('span', {}, value))),
    ...(checks.robot_poses > 0 ? checksBar(checks) : []),
  )
}

export function keys(spatial) {
  const rows = [
    ['space', 'play or pause'],
    ['← →', 'back, on (with shift: faster)'],
    ['home end', 'start, goal'],
    ['1 … 9', 'show or hide a robot'],
    ['r', 'see all again'],
    ['mouse', spatial ? 'turn; right: move; wheel: zoom' : 'move; wheel: zoom'],
    ['fingers', spatial ? 'one: turn; two: move, zoom' : 'one: move; two: zoom'],
  ]
  return section('Keys', true, ...rows.map(([key, text]) => make('div', { class: 'row key' }, make('kbd', {}, key), make('span', {}, text))))
}
