package lightning.editor.window.property;

import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.format.jen.FileKind;
import lightning.scene.ValueKind;

/**
 * How a file of an attribute is chosen.
 *
 * @param command what choosing one does
 * @param kind    which files serve
 * @param help    what it is, in the editor's language
 */
record FileUse(Command command, FileKind kind, String help) {
    static FileUse of(ValueKind.Filed<?> kind) {
        return switch (kind) {
            case ValueKind.Projecting _ -> new FileUse(Command.CHOOSE_GOBO, FileKind.TEXTURE,
                    Texts.of("A picture that the light projects: black holds it back"));
            case ValueKind.Shining _ -> new FileUse(Command.CHOOSE_PROFILE, FileKind.PROFILE,
                    Texts.of("How strongly the light shines in each direction, as an IES file tells"));
            case ValueKind.Surrounding _ -> new FileUse(Command.CHOOSE_ENVIRONMENT, FileKind.ENVIRONMENT,
                    Texts.of("A picture of all that is far around, which lights the scene"));
        };
    }
}
