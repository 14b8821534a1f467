package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.cue.Lighting;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.format.jen.JenFile;
import lightning.scene.Scene;
import lightning.scene.Stage;

/** The commands about light rigs as files. A rig is a scene file of lights and banks; any scene's lights can be taken too. */
final class RigActions {
    private final SceneEditor editor;
    private final FileThread files;
    private final FilePrompt prompt;
    private final Notices notices;

    private RigActions(SceneEditor editor, FileThread files, FilePrompt prompt, Notices notices) {
        this.editor = editor;
        this.files = files;
        this.prompt = prompt;
        this.notices = notices;
    }

    static void addTo(Commands commands, SceneEditor editor, FileThread files, FilePrompt prompt, Notices notices) {
        var actions = new RigActions(editor, files, prompt, notices);
        commands.setAction(Command.LOAD_RIG, () -> actions.load(Lighting::rigOn));
        commands.setAction(Command.ADD_RIG, () -> actions.load(Lighting::addedTo));
        commands.setAction(Command.SAVE_RIG, actions::save);
    }

    private Path folder() {
        return editor.document().file().toAbsolutePath().getParent();
    }

    private void load(BiFunction<Lighting, Scene, Change> edit) {
        Optional<Path> chosen = prompt.rig(folder());
        if (chosen.isEmpty()) {
            return;
        }
        Path folder = folder();
        Stage stage = editor.scene().stage();
        var document = editor.document();
        files.inTurn(() -> Lighting.read(chosen.get(), folder, stage), lighting -> {
            if (document == editor.document()) {
                if (editor.editOrReport(scene -> edit.apply(lighting, scene)).isEmpty()) {
                    editor.message().show(
                            Texts.of("Lights of {0}: {1}", Quote.path(chosen.get().getFileName()), lighting.rig().lights().size()));
                }
            }
        }, why -> notices.failed(Texts.of("The lights could not be read"), why));
    }

    private void save() {
        String name = JenFile.stem(editor.document().name()) + "-lights" + JenFile.ENDING;
        prompt.rigToWrite(folder().resolve(name))
                .ifPresent(chosen -> notices.withEnding(files, chosen, JenFile.ENDING, this::write));
    }

    private void write(Path file) {
        if (file.toAbsolutePath().normalize().equals(editor.document().file().toAbsolutePath().normalize())) {
            editor.message().show(
                    Texts.of("{0} is the open scene: lights alone in its place would lose its shapes", Quote.path(file.getFileName())));
            return;
        }
        Lighting lighting = Lighting.of(editor.scene());
        files.inTurn(() -> {
            lighting.write(file);
            return file;
        }, _ -> editor.message().show(Texts.of("Saved {0}", Quote.path(file.getFileName()))),
                why -> notices.failed(Texts.of("The lights could not be saved"), why));
    }
}
