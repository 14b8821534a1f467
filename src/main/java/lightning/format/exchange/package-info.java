/**
 * Exchange with other programs: imports scenes to {@code .jen} files, and exports lights.
 * Readers of single formats have packages of their own; this one turns their content into a scene.
 *
 * <pre>{@code
 * ImportedScene scene = SceneImporter.read(Path.of("house.glb"), Path.of("house.jen"), LightUnits.CANDELA, Progress.NONE);
 * scene.write();
 * }</pre>
 */
@NullMarked
package lightning.format.exchange;

import org.jspecify.annotations.NullMarked;
