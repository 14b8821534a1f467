/** The page for a start: shipped scenes, recent files, and lessons that run in the editor. */
package lightning.editor.window.welcome;
