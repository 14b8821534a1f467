package lightning.bench;

import lightning.scene.Scene;

/**
 * A scene to measure.
 *
 * @param name its file's without the ending; unique in a run
 */
public record NamedScene(String name, Scene scene) {}
