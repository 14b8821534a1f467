/**
 * Scenes in the language of POV-Ray 3.7, for pictures and times to compare with.
 *
 * <pre>{@code
 * PovScene pov = PovScene.of(scene, "bird");
 * pov.write(Path.of("bird.pov"));       // and its textures beside it
 * pov.losses().forEach(System.out::println);
 * }</pre>
 *
 * <p>The coordinates stay as they are: POV-Ray's camera is given right-handed axes. Everything that POV-Ray cannot say,
 * or not exactly, is told in {@link lightning.format.pov.PovScene#losses()} and in the file.
 */
package lightning.format.pov;
