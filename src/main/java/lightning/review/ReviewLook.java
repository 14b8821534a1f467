package lightning.review;

import lightning.scene.Scene;

/**
 * Stored look of a scene, as a page offers it.
 *
 * @param name  name that the page shows
 * @param scene the scene of the picture with the lights of the look
 */
public record ReviewLook(String name, Scene scene) {}
