/** Panel of sequences: a contact sheet of shots that share the lights of one rig. */
@NullMarked
package lightning.editor.window.sequence;

import org.jspecify.annotations.NullMarked;
