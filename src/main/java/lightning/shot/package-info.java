/**
 * All frames of a shot kept and relit: an edit goes to every frame, the one that is looked at first.
 *
 * <pre>{@code
 * try (RelitShot shot = RelitShot.of(first, last, new LocalKeeper(Options.DEFAULT, bytes), listener)) {
 *     shot.edit(new Take(scene, keys));
 *     shot.focus(17);
 *     shot.edit(new Take(brighter, keys));
 * }
 * }</pre>
 *
 * <p>What decides which frame is next ({@link lightning.shot.FrameQueue}) knows no renderer; what holds frames
 * ({@link lightning.shot.FrameKeeper}) knows no order.
 */
package lightning.shot;
