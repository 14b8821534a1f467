/**
 * Export of scenes to POV-Ray 3.7, to compare images and times.
 *
 * <pre>{@code
 * PovScene pov = PovScene.of(scene, "bird");
 * pov.write(Path.of("bird.pov"));       // and its textures next to it
 * pov.losses().forEach(System.out::println);
 * }</pre>
 *
 * <p>Coordinates stay unchanged: POV-Ray's camera gets right-handed axes. Features that POV-Ray does not support exactly are
 * listed in {@link lightning.format.pov.PovScene#losses()} and in the file.
 */
@NullMarked
package lightning.format.pov;

import org.jspecify.annotations.NullMarked;
