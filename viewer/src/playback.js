// Which frame is shown. The whole path takes ten seconds at speed 1; pauses, and what slow machines leave out, change no
// frame.
const FRAMES = 600
const PER_SECOND = 60

export class Playback {
  /** @param show is called with each new frame */
  constructor(end, show) {
    this.last = end > 0 ? FRAMES : 0
    this.end = end
    this.show = show
    this.frame = 0
    this.speed = 1
    this.playing = false
  }

  get time() {
    return this.last > 0 ? (this.end * this.frame) / this.last : 0
  }

  seek(frame) {
    this.frame = Math.min(Math.max(frame, 0), this.last)
    this.show()
  }

  play() {
    if (this.playing || this.last === 0) return
    if (this.frame >= this.last) this.frame = 0
    this.playing = true
    let before = performance.now()
    const step = (now) => {
      const frame = this.frame + (Math.max(now - before, 0) / 1000) * PER_SECOND * this.speed
      before = now
      if (frame >= this.last) this.playing = false
      else this.next = requestAnimationFrame(step)
      this.seek(frame)
    }
    this.next = requestAnimationFrame(step)
    this.show()
  }

  pause() {
    this.playing = false
    cancelAnimationFrame(this.next)
    this.show()
  }

  toggle() {
    if (this.playing) this.pause()
    else this.play()
  }
}
