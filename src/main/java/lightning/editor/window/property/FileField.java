package lightning.editor.window.property;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.MenuButton;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.FileImporter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.format.jen.PropertyEdit;
import lightning.format.jen.asset.FileKind;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.FileAsset;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;

/** Field for a file asset of the selected light or an environment, chosen from the files next to the scene. Reads files in the background. */
final class FileField<F extends FileAsset> extends StackPane {
    private final SceneEditor editor;
    private final FileImporter files;
    private final Owner<F> owner;
    private final MenuButton choice;
    private final DisabledReason disabledReason;

    /** Owner of the asset: the selected light or an environment. */
    private sealed interface Owner<F extends FileAsset> {
        SceneAttribute<?, Optional<F>> attribute();

        default String title() {
            return attribute().title();
        }

        /** Returns the name of the owner; the selected light's by default. */
        default String name(SceneEditor editor) {
            return editor.selection().lightName();
        }

        /** Returns the current asset's display text. */
        String text(EditorState now);

        /** Returns why the owner cannot have the asset, as a clause, or empty if it can. */
        Optional<String> disabledReason(EditorState now);

        /** Returns the scene with an asset read from a file; {@code lightName} is the selected light's name. */
        Scene read(Scene scene, String lightName, String file, Path folder);

        /** Returns {@code target} with the asset of {@code source}. */
        Scene copy(Scene source, Scene target, String lightName);
    }

    private record LightOwner<F extends FileAsset>(LightAttribute<Optional<F>> attribute) implements Owner<F> {
        @Override
        public String text(EditorState now) {
            return now.selectedLight().map(attribute::format).map(Messages::tr).orElse(Messages.tr("none"));
        }

        @Override
        public Optional<String> disabledReason(EditorState now) {
            return now.selectedLight().isEmpty() ? Optional.of(Messages.tr("no light is selected"))
                    : attribute.inactiveReason(now.selectedLight().get().type());
        }

        @Override
        public Scene read(Scene scene, String lightName, String file, Path folder) {
            return PropertyEdit.setFile(scene, new SceneElement.OfLight(lightName), attribute.name(), file, folder);
        }

        @Override
        public Scene copy(Scene source, Scene target, String lightName) {
            Light light = target.light(lightName)
                    .orElseThrow(() -> new RefusalException(Messages.tr("the light no longer exists")));
            return target.withLight(attribute.copy(source.light(lightName).orElseThrow(), light));
        }
    }

    private record DomeOwner(Supplier<String> dome) implements Owner<Environment> {
        @Override
        public SceneAttribute<Dome, Optional<Environment>> attribute() {
            return Dome.ENVIRONMENT;
        }

        @Override
        public String title() {
            return dome.get().equals(Dome.OWN) ? World.ENVIRONMENT.title() : attribute().title();
        }

        @Override
        public String name(SceneEditor editor) {
            return dome.get();
        }

        @Override
        public String text(EditorState now) {
            return now.scene().world().domeOrOwn(dome.get()).map(attribute()::format).map(Messages::tr).orElse(Messages.tr("none"));
        }

        @Override
        public Optional<String> disabledReason(EditorState now) {
            return Optional.empty();
        }

        @Override
        public Scene read(Scene scene, String name, String file, Path folder) {
            return PropertyEdit.setFile(scene, name.equals(Dome.OWN) ? SceneElement.WORLD : new SceneElement.OfDome(name),
                    Dome.ENVIRONMENT.name(), file, folder);
        }

        @Override
        public Scene copy(Scene source, Scene target, String name) {
            Dome known = target.world().domeOrOwn(name)
                    .orElseThrow(() -> new RefusalException(Messages.tr("the dome no longer exists")));
            return target.withWorld(target.world().withDome(name, attribute().copy(source.world().domeOrOwn(name).orElseThrow(), known)));
        }
    }

    private FileField(SceneEditor editor, CommandRegistry commands, FileImporter files, Owner<F> owner, FileChoice fileChoice,
            ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        this.files = files;
        this.owner = owner;
        choice = new FileMenu(commands, files, Messages.tr("none"), fileChoice.command(), fileChoice.kind(), this::set,
                () -> browse(fileChoice.command(), fileChoice.kind()));
        choice.setId(fileChoice.id());
        choice.setAccessibleText(Messages.tr(owner.title()));
        choice.setMaxWidth(Double.MAX_VALUE);
        getChildren().add(choice);
        disabledReason = new DisabledReason(this, choice, fileChoice.help());
        visibleState.subscribe(this::show);
    }

    /**
     * Creates the field of a light attribute.
     *
     * @param kind  kind of the attribute
     * @param visibleState  state as in {@link PropertyPane}
     */
    static <F extends FileAsset> FileField<F> forLight(SceneEditor editor, CommandRegistry commands, FileImporter files,
            LightAttribute<Optional<F>> attribute, ValueKind.AssetKind<?> kind, ObservableValue<EditorState> visibleState) {
        return new FileField<>(editor, commands, files, new LightOwner<>(attribute), FileChoice.of(kind), visibleState);
    }

    /** Creates the field of the environment map. */
    static FileField<Environment> forWorld(SceneEditor editor, CommandRegistry commands, FileImporter files,
            ObservableValue<EditorState> visibleState) {
        return new FileField<>(editor, commands, files, new DomeOwner(() -> Dome.OWN), FileChoice.of(new ValueKind.EnvironmentKind()),
                visibleState);
    }

    /** Creates the field of a dome's image. */
    static FileField<Environment> forDome(SceneEditor editor, CommandRegistry commands, FileImporter files, Supplier<String> dome,
            ObservableValue<EditorState> visibleState) {
        FileChoice choice = FileChoice.of(new ValueKind.EnvironmentKind());
        return new FileField<>(editor, commands, files, new DomeOwner(dome),
                new FileChoice("dome-environment", choice.command(), choice.kind(), choice.help()), visibleState);
    }

    /** Shows the asset of the owner, which may be another one than before. */
    void show(EditorState state) {
        choice.setText(owner.text(state));
        disabledReason.set(owner.disabledReason(state));
    }

    private void browse(Command command, FileKind kind) {
        String name = owner.name(editor);
        files.promptAndImport(command.plainTitle(), kind, file -> {
            if (owner.name(editor).equals(name)) {
                set(file);
            }
        }, editor.message()::show);
    }

    /** Reads a file in the background and applies the asset to the scene as it is then. */
    private void set(String file) {
        String name = owner.name(editor);
        Path folder = files.folder();
        Scene requestScene = editor.scene();
        files.files().runConcurrently(() -> owner.read(requestScene, name, file, folder),
                loaded -> editor.editOrReport(scene -> EditOutcome.of(() -> owner.copy(loaded, scene, name))),
                e -> editor.message().show(ErrorMessage.of(e)));
    }
}
