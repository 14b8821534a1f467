/**
 * Relighting of all frames of a shot: an edit updates every frame, the focused one first.
 * Keyframes and their values belong to {@code scene.shot}.
 *
 * <pre>{@code
 * try (ShotRelighter shot = ShotRelighter.of(first, last, new LocalFrameHost(RenderOptions.DEFAULT, bytes), listener)) {
 *     shot.setRevision(new ShotRevision(scene, keys));
 *     shot.focus(17);
 *     shot.setRevision(new ShotRevision(brighter, keys));
 * }
 * }</pre>
 *
 * <p>The scheduler ({@link lightning.shot.FrameQueue}) is independent of renderers; frame hosts ({@link lightning.shot.FrameHost}) are
 * independent of the order.
 */
@NullMarked
package lightning.shot;

import org.jspecify.annotations.NullMarked;
