package lightning.editor.window.property;

import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.format.jen.asset.FileKind;
import lightning.scene.attribute.ValueKind;

/**
 * Settings for choosing an attribute's file.
 *
 * @param command  command of choosing a file
 * @param kind  accepted kind of files
 * @param help  tooltip in the interface language
 */
record FileChoice(Command command, FileKind kind, String help) {
    static FileChoice of(ValueKind.AssetKind<?> kind) {
        return switch (kind) {
            case ValueKind.GoboKind _ -> new FileChoice(Command.CHOOSE_GOBO, FileKind.TEXTURE,
                    Messages.tr("Image projected by the light (gobo)"));
            case ValueKind.LightTextureKind _ -> new FileChoice(Command.CHOOSE_LIGHT_TEXTURE, FileKind.TEXTURE,
                    Messages.tr("Image on the light's face, such as a screen or a window"));
            case ValueKind.ProfileKind _ -> new FileChoice(Command.CHOOSE_PROFILE, FileKind.PROFILE,
                    Messages.tr("Intensity in each direction, from an IES file"));
            case ValueKind.EnvironmentKind _ -> new FileChoice(Command.CHOOSE_ENVIRONMENT, FileKind.ENVIRONMENT,
                    Messages.tr("Environment map that lights the scene"));
        };
    }
}
