/**
 * glTF 2.0 files (Khronos Group, glTF 2.0 Specification, 2021), text and binary, with their content validated.
 *
 * <pre>{@code
 * GltfFile file = GltfFile.read(Path.of("house.glb"), Progress.NONE);
 * List<GltfPart> parts = GltfMeshReader.read(file, new ConversionNotes());
 * }</pre>
 */
@NullMarked
package lightning.format.gltf;

import org.jspecify.annotations.NullMarked;
