/**
 * Background rendering for the editor: a queue that keeps the newest request, a thread that runs it, and another that verifies and measures
 * when idle. {@link lightning.document.loop.RenderLoop} is thread-safe.
 * Panes, and where pixels are shown, belong to {@code editor.window}.
 */
@NullMarked
package lightning.document.loop;

import org.jspecify.annotations.NullMarked;
