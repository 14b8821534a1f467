/**
 * The loop that renders beside the window: a queue of what is wanted, where the newest wish wins, a thread that works it off,
 * and another that verifies and measures while nobody works. {@link lightning.editor.loop.RenderLoop} is safe for several threads.
 */
package lightning.editor.loop;
