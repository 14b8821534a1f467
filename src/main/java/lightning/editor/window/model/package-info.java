/**
 * Model of the editor window without panes: document, picture and progress, display settings and preferences.
 * Panes belong to the packages beside it.
 */
@NullMarked
package lightning.editor.window.model;

import org.jspecify.annotations.NullMarked;
