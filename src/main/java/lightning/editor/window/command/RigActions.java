package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.EditOutcome;
import lightning.document.FileThread;
import lightning.document.look.Lighting;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.format.jen.JenFile;
import lightning.scene.Scene;
import lightning.scene.Stage;

/** Actions of the light rig commands. A rig is a scene file with lights and light groups; the lights of any scene can be imported too. */
record RigActions(SceneEditor editor, FileThread files, FilePrompt prompt, EditorDialogs notices) {
    static void register(CommandRegistry commands, SceneEditor editor, FileThread files, FilePrompt prompt, EditorDialogs notices) {
        var actions = new RigActions(editor, files, prompt, notices);
        commands.setAction(Command.LOAD_RIG, () -> actions.load(Lighting::applyRigTo));
        commands.setAction(Command.ADD_RIG, () -> actions.load(Lighting::addTo));
        commands.setAction(Command.SAVE_RIG, actions::save);
    }

    private Path folder() {
        return ParentFolder.of(editor.document().file());
    }

    /** Returns the folder to propose, which is not the program's for a copy of a shipped scene. */
    private Path proposedFolder() {
        return ParentFolder.of(editor.document().proposedFile("rig"));
    }

    private void load(BiFunction<Lighting, Scene, EditOutcome> edit) {
        Optional<Path> chosen = prompt.rigToOpen(proposedFolder());
        if (chosen.isEmpty()) {
            return;
        }
        Path folder = folder();
        Stage stage = editor.scene().stage();
        var document = editor.document();
        files.runInOrder(() -> Lighting.read(chosen.get(), folder, stage), lighting -> {
            if (document == editor.document()) {
                if (editor.editOrReport(scene -> edit.apply(lighting, scene)).isEmpty()) {
                    editor.message().show(
                            Messages.tr("Lights imported from {0}: {1}", Quote.path(chosen.get().getFileName()),
                                    lighting.rig().lights().size()));
                }
            }
        }, failure -> notices.showFailure(Messages.tr("The lights could not be read"), failure));
    }

    private void save() {
        String name = JenFile.stem(editor.document().name()) + "-lights" + JenFile.EXTENSION;
        prompt.rigToWrite(proposedFolder().resolve(name))
                .ifPresent(chosen -> notices.withExtension(files, chosen, JenFile.EXTENSION, this::write));
    }

    private void write(Path file) {
        if (file.toAbsolutePath().normalize().equals(editor.document().file().toAbsolutePath().normalize())) {
            editor.message().show(
                    Messages.tr("{0} is the open scene; saving only its lights there would delete its objects",
                            Quote.path(file.getFileName())));
            return;
        }
        Lighting lighting = Lighting.of(editor.scene());
        files.runInOrder(() -> {
            lighting.write(file);
            return file;
        }, _ -> editor.message().show(Messages.tr("Saved {0}", Quote.path(file.getFileName()))),
                failure -> notices.showFailure(Messages.tr("The lights could not be saved"), failure));
    }
}
