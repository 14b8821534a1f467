/** The page for a start: shipped scenes, recent files, and lessons that run in the editor. */
@NullMarked
package lightning.editor.window.welcome;

import org.jspecify.annotations.NullMarked;
