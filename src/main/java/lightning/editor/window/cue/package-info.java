/** Gallery of saved looks (cues), which can be applied, compared and blended. */
@NullMarked
package lightning.editor.window.cue;

import org.jspecify.annotations.NullMarked;
