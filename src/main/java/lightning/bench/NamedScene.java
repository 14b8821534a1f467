package lightning.bench;

import java.nio.file.Path;
import lightning.scene.Scene;

/**
 * A scene to measure.
 *
 * @param name its file's without the ending; unique in a run
 * @param file where it was read from, for processes of their own; null where from nowhere, and there are none then
 */
public record NamedScene(String name, Scene scene, Path file) {}
