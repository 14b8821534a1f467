package lightning.bench;

import java.nio.file.Path;
import lightning.scene.Scene;

/**
 * Scene to measure.
 *
 * @param name file name without extension; unique in a run
 * @param file source file for cold-start processes; null if none, which skips them
 */
public record NamedScene(String name, Scene scene, Path file) {}
