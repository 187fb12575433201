// Certificates: balls that are known to be free, as bubbles. The largest come first.
import {
  CircleGeometry,
  Color,
  Group,
  IcosahedronGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  RingGeometry,
  ShaderMaterial,
} from 'three'
import { FLAT, look, ORDER } from './look.js'

const bubble = () =>
  new ShaderMaterial({
    uniforms: { color: { value: new Color(look.certificate) } },
    vertexShader: `
      varying vec3 outwards;
      varying vec3 towards;
      void main() {
        vec4 seen = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
        outwards = normalMatrix * mat3(instanceMatrix) * normal;
        towards = -seen.xyz;
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: `
      uniform vec3 color;
      varying vec3 outwards;
      varying vec3 towards;
      void main() {
        float rim = 1.0 - abs(dot(normalize(outwards), normalize(towards)));
        gl_FragColor = vec4(color, 0.03 + 0.42 * pow(rim, 3.0));
        #include <colorspace_fragment>
      }`,
    transparent: true,
    depthWrite: false,
  })

export class Certificates {
  constructor(plan) {
    this.group = new Group()
    this.number = plan.certificates.length / 4
    // Balls of space hide each other sooner than those of the plane.
    this.few = Math.min(this.number, plan.spatial ? 24 : 60)
    this.meshes = plan.spatial
      ? [this.balls(plan, new IcosahedronGeometry(1, 8), bubble())]
      : [
          this.balls(plan, new CircleGeometry(1, 72), new MeshBasicMaterial({ color: look.certificate, ...FLAT, opacity: 0.1 })),
          this.balls(plan, new RingGeometry(0.985, 1, 72), new MeshBasicMaterial({ color: look.certificate, ...FLAT, opacity: 0.55 })),
        ]
    this.group.add(...this.meshes)
  }

  balls(plan, geometry, material) {
    const mesh = new InstancedMesh(geometry, material, this.number)
    const matrix = new Matrix4()
    for (let i = 0; i < this.number; ++i) {
      const [x, y, z, radius] = plan.certificates.subarray(4 * i, 4 * i + 4)
      mesh.setMatrixAt(i, matrix.makeScale(radius, radius, radius).setPosition(x, y, z))
    }
    mesh.renderOrder = ORDER.certificates
    mesh.frustumCulled = false
    return mesh
  }

  /** Show the `count` largest. */
  setCount(count) {
    for (const mesh of this.meshes) mesh.count = Math.min(count, this.number)
  }
}
