/**
 * All frames of a shot kept and relit: an edit goes to every frame, the one that is looked at first.
 *
 * <pre>{@code
 * try (ShotRelighter shot = ShotRelighter.of(first, last, new LocalFrameHost(RenderOptions.DEFAULT, bytes), listener)) {
 *     shot.edit(new ShotRevision(scene, keys));
 *     shot.focus(17);
 *     shot.edit(new ShotRevision(brighter, keys));
 * }
 * }</pre>
 *
 * <p>What decides which frame is next ({@link lightning.shot.FrameQueue}) knows no renderer; what holds frames
 * ({@link lightning.shot.FrameHost}) knows no order.
 */
package lightning.shot;
