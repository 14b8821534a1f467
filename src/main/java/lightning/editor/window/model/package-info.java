/**
 * Model of the editor window without panes: document, picture and progress, display settings and preferences.
 * Panes have packages of their own.
 */
@NullMarked
package lightning.editor.window.model;

import org.jspecify.annotations.NullMarked;
