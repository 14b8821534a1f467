package lightning.editor.window.property;

import lightning.base.text.Messages;
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
record FileChoice(Command command, FileKind kind, String help) {
    static FileChoice of(ValueKind.AssetKind<?> kind) {
        return switch (kind) {
            case ValueKind.GoboKind _ -> new FileChoice(Command.CHOOSE_GOBO, FileKind.TEXTURE,
                    Messages.tr("Image projected by the light (gobo)"));
            case ValueKind.ProfileKind _ -> new FileChoice(Command.CHOOSE_PROFILE, FileKind.PROFILE,
                    Messages.tr("Intensity in each direction, from an IES file"));
            case ValueKind.EnvironmentKind _ -> new FileChoice(Command.CHOOSE_ENVIRONMENT, FileKind.ENVIRONMENT,
                    Messages.tr("Environment map that lights the scene"));
        };
    }
}
