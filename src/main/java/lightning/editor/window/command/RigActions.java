package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.cue.Lighting;
import lightning.editor.window.model.EditorModel;
import lightning.format.jen.JenFile;
import lightning.scene.Scene;
import lightning.scene.Stage;

/** The commands about light rigs as files. A rig is a scene file of lights and banks; any scene's lights can be taken too. */
final class RigActions {
    private final EditorModel model;
    private final FilePrompt prompt;
    private final Notices notices;

    private RigActions(EditorModel model, FilePrompt prompt, Notices notices) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
    }

    static void addTo(EditorModel model, FilePrompt prompt, Notices notices) {
        var actions = new RigActions(model, prompt, notices);
        model.commands().setAction(Command.LOAD_RIG, () -> actions.load(Lighting::rigOn));
        model.commands().setAction(Command.ADD_RIG, () -> actions.load(Lighting::addedTo));
        model.commands().setAction(Command.SAVE_RIG, actions::save);
    }

    private Path folder() {
        return model.document().file().toAbsolutePath().getParent();
    }

    private void load(BiFunction<Lighting, Scene, Change> edit) {
        Optional<Path> chosen = prompt.rig(folder());
        if (chosen.isEmpty()) {
            return;
        }
        Path folder = folder();
        Stage stage = model.scene().stage();
        var document = model.document();
        model.files().inTurn(() -> Lighting.read(chosen.get(), folder, stage), lighting -> {
            if (document == model.document()) {
                model.edit(scene -> edit.apply(lighting, scene)).ifPresentOrElse(model::say,
                        () -> model.say(
                                Texts.of("Lights of {0}: {1}", Quote.path(chosen.get().getFileName()), lighting.rig().lights().size())));
            }
        }, why -> notices.failed(Texts.of("The lights could not be read"), why));
    }

    private void save() {
        String name = JenFile.stem(model.document().name()) + "-lights" + JenFile.ENDING;
        prompt.rigToWrite(folder().resolve(name))
                .ifPresent(chosen -> notices.withEnding(model.files(), chosen, JenFile.ENDING, this::write));
    }

    private void write(Path file) {
        if (file.toAbsolutePath().normalize().equals(model.document().file().toAbsolutePath().normalize())) {
            model.say(Texts.of("{0} is the open scene: lights alone in its place would lose its shapes", Quote.path(file.getFileName())));
            return;
        }
        Lighting lighting = Lighting.of(model.scene());
        model.files().inTurn(() -> {
            lighting.write(file);
            return file;
        }, _ -> model.say(Texts.of("Saved {0}", Quote.path(file.getFileName()))),
                why -> notices.failed(Texts.of("The lights could not be saved"), why));
    }
}
