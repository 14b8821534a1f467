/**
 * The editor without its window: commands and when they are enabled ({@link lightning.editor.Command}), and the model that panes share
 * ({@link lightning.editor.Workbench}).
 * Edits and undo belong to {@code document}; JavaFX belongs to {@code editor.window}.
 */
@NullMarked
package lightning.editor;

import org.jspecify.annotations.NullMarked;
