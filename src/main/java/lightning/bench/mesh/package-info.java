/** Ray throughput on single meshes: generated meshes, ray sets, our own tracer, and Embree if installed. */
@NullMarked
package lightning.bench.mesh;

import org.jspecify.annotations.NullMarked;
