/**
 * Animation: keyframes of a scene's camera, lights, light groups, shapes and groups, and the scene at each frame.
 * Rendering of frames belongs to {@code shot}.
 */
@NullMarked
package lightning.scene.shot;

import org.jspecify.annotations.NullMarked;
