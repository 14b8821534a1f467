/**
 * Background rendering for the editor: a queue that keeps the newest request, a thread that runs it, and another that verifies and measures
 * when idle. {@link lightning.editor.loop.RenderLoop} is thread-safe.
 */
@NullMarked
package lightning.editor.loop;

import org.jspecify.annotations.NullMarked;
