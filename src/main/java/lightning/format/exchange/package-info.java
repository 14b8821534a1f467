/**
 * Scenes of other programs: brought in as {@code .jen} files, and their lights taken back.
 *
 * <pre>{@code
 * ImportedScene scene = SceneImporter.read(Path.of("house.glb"), Path.of("house.jen"), LightUnits.CANDELA, Progress.NONE);
 * scene.write();
 * }</pre>
 */
package lightning.format.exchange;
