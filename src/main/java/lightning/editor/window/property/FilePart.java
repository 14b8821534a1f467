package lightning.editor.window.property;

import java.nio.file.Path;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.MenuButton;
import javafx.scene.layout.StackPane;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.Situation;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileBringer;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.Obstacle;
import lightning.format.jen.FileKind;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Attribute;
import lightning.scene.FromFile;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Panorama;
import lightning.scene.Scene;
import lightning.scene.ValueKind;
import lightning.scene.World;

/** What the selected light or the world has from a file: one of those that lie beside the scene. It is read on a thread of its own. */
final class FilePart<F extends FromFile> extends StackPane {
    private final SceneEditor editor;
    private final FileBringer files;
    private final Owner<F> owner;
    private final MenuButton choice;
    private final Obstacle obstacle;

    /** Who has it. */
    private sealed interface Owner<F extends FromFile> {
        Attribute<?, Optional<F>> attribute();

        /** What it has now, for people. */
        String text(Situation now);

        /** Why it can have none now: a clause; empty where it can. */
        Optional<String> obstacle(Situation now);

        /** The scene with what a file holds; {@code who} is the selected light's name. */
        Scene read(Scene scene, String who, String file, Path folder);

        /** {@code to} with what {@code from} has. */
        Scene copy(Scene from, Scene to, String who);
    }

    private record OfLight<F extends FromFile>(LightAttribute<Optional<F>> attribute) implements Owner<F> {
        @Override
        public String text(Situation now) {
            return now.selected().map(attribute::text).map(Texts::of).orElse(Texts.of("none"));
        }

        @Override
        public Optional<String> obstacle(Situation now) {
            return now.selected().isEmpty() ? Optional.of(Texts.of("no light is selected"))
                    : attribute.obstacle(now.selected().get().type());
        }

        @Override
        public Scene read(Scene scene, String who, String file, Path folder) {
            return PropertyEdit.file(scene, who, attribute, file, folder);
        }

        @Override
        public Scene copy(Scene from, Scene to, String who) {
            Light light = to.light(who).orElseThrow(() -> new IllegalArgumentException(Texts.of("the light is gone")));
            return to.withLight(attribute.copy(from.light(who).orElseThrow(), light));
        }
    }

    private record OfWorld(Attribute<World, Optional<Panorama>> attribute) implements Owner<Panorama> {
        @Override
        public String text(Situation now) {
            return attribute.text(now.scene().world());
        }

        @Override
        public Optional<String> obstacle(Situation now) {
            return Optional.empty();
        }

        @Override
        public Scene read(Scene scene, String who, String file, Path folder) {
            return PropertyEdit.environment(scene, file, folder);
        }

        @Override
        public Scene copy(Scene from, Scene to, String who) {
            return to.withWorld(attribute.copy(from.world(), to.world()));
        }
    }

    private FilePart(SceneEditor editor, Commands commands, FileBringer files, Owner<F> owner, FileUse use,
            ObservableValue<Situation> seen) {
        this.editor = editor;
        this.files = files;
        this.owner = owner;
        choice = new FileMenu(commands, files, Texts.of("none"), use.command(), use.kind(), this::set,
                () -> browse(use.command(), use.kind()));
        choice.setId(owner.attribute().name());
        choice.setAccessibleText(Texts.of(owner.attribute().title()));
        choice.setMaxWidth(Double.MAX_VALUE);
        getChildren().add(choice);
        obstacle = new Obstacle(this, choice, use.help());
        seen.subscribe(this::show);
    }

    /**
     * Of the selected light.
     *
     * @param kind that of the attribute
     * @param seen as in {@link PropertyPane}
     */
    static <F extends FromFile> FilePart<F> of(SceneEditor editor, Commands commands, FileBringer files,
            LightAttribute<Optional<F>> attribute, ValueKind.Filed<?> kind, ObservableValue<Situation> seen) {
        return new FilePart<>(editor, commands, files, new OfLight<>(attribute), FileUse.of(kind), seen);
    }

    /** The same of the environment. */
    static FilePart<Panorama> ofWorld(SceneEditor editor, Commands commands, FileBringer files, ObservableValue<Situation> seen) {
        return new FilePart<>(editor, commands, files, new OfWorld(World.ENVIRONMENT), FileUse.of(new ValueKind.Surrounding()), seen);
    }

    private void show(Situation now) {
        choice.setText(owner.text(now));
        obstacle.set(owner.obstacle(now));
    }

    private void browse(Command command, FileKind kind) {
        String who = editor.selection().lightName();
        files.browse(command.plainTitle(), kind, file -> {
            if (editor.selection().lightName().equals(who)) {
                set(file);
            }
        }, editor.message()::show);
    }

    /** What was read is taken over by the scene as it is then. */
    private void set(String file) {
        String who = editor.selection().lightName();
        Path folder = files.folder();
        Scene asked = editor.scene();
        files.files().beside(() -> owner.read(asked, who, file, folder),
                read -> editor.editOrReport(scene -> Change.of(() -> owner.copy(read, scene, who))),
                e -> editor.message().show(Sentence.of(e)));
    }
}
