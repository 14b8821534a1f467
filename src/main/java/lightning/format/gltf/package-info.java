/**
 * Files of glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021), as text and as binary: what they say, held to what they have.
 *
 * <pre>{@code
 * GltfFile file = GltfFile.read(Path.of("house.glb"), Progress.NONE);
 * List<GltfPart> parts = GltfMeshReader.read(file, new ConversionNotes());
 * }</pre>
 */
package lightning.format.gltf;
