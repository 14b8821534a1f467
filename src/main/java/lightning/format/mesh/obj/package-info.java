/**
 * Wavefront OBJ files and their MTL files (Wavefront, Advanced Visualizer Manual, appendix B1, about 1992).
 *
 * <pre>{@code
 * try (ByteSource source = ByteSource.open(Path.of("house.obj"), Progress.NONE)) {
 *     ObjFile file = ObjReader.read(source, new ConversionNotes());
 *     Mesh walls = file.parts().getFirst().mesh();
 * }
 * }</pre>
 */
@NullMarked
package lightning.format.mesh.obj;

import org.jspecify.annotations.NullMarked;
