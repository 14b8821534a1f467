/** Ray throughput on single meshes: generated meshes, ray sets, our own tracer, and Embree if installed. */
package lightning.bench.mesh;
