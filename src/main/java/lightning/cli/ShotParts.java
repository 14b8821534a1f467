package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.cli.option.FramesOption;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ShotFrames;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.sequence.LoadedSequence;
import lightning.format.sequence.SequenceReader;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Options that choose shots and frames: of a scene with a shot, or of a sequence. */
final class ShotParts {
    @Mixin
    private FramesOption frames;
    @Option(names = "--shots", paramLabel = "NAME", split = ",", description = "Shots of a sequence, separated by commas (default: all).")
    private List<String> shots = List.of();

    /**
     * Shot with its chosen frames.
     *
     * @param name  name of the scene, without its extension, or of a shot of a sequence
     * @param file  scene file
     * @param scene scene without keyframes applied
     */
    record Part(String name, Path file, Scene scene, ShotFrames frames) {}

    /** Chosen shots of a scene or of a sequence. */
    record Parts(List<Part> parts, boolean areOfSequence) {}

    /**
     * Reads a scene or a sequence, and checks all chosen frames.
     *
     * @param picture options that change the picture of every shot
     */
    Parts read(Path file, PictureOptions picture, Console console) throws IOException, JenException, BadInputException {
        if (!SequenceReader.isSequence(file)) {
            if (!shots.isEmpty()) {
                throw new BadInputException("--shots works only for a sequence");
            }
            JenDocument document = SceneFile.read(file, console);
            ShotFrames chosen = frames.of(document, file);
            Scene scene = picture.apply(document.scene());
            chosen.check(scene);
            return new Parts(List.of(new Part(JenFile.stem(file.getFileName().toString()), file, scene, chosen)), false);
        }
        LoadedSequence sequence = LoadedSequence.read(file);
        for (String name : shots) {
            if (sequence.sequence().shot(name).isEmpty()) {
                throw new BadInputException(Console.text("%s: there is no shot %s; expected one of %s", file, Quote.of(name),
                        String.join(", ", sequence.sequence().names())));
            }
        }
        List<Part> parts = new ArrayList<>();
        for (LoadedSequence.LoadedShot shot : sequence.shots()) {
            if (shots.isEmpty() || shots.contains(shot.name())) {
                shot.document().notes().forEach(note -> console.warn("%s", note));
                parts.add(part(file, sequence, shot, picture));
            }
        }
        return new Parts(parts, true);
    }

    private Part part(Path file, LoadedSequence sequence, LoadedSequence.LoadedShot shot, PictureOptions picture)
            throws BadInputException {
        AnimatedScene lit;
        try {
            lit = sequence.lit(shot, sequence.rig());
        } catch (RefusalException e) {
            throw new BadInputException(Console.text("%s: %s", file, e.getMessage()));
        }
        Scene scene = picture.apply(lit.base());
        ShotFrames chosen = frames.of(lit.shot().orElseThrow());
        chosen.check(scene);
        return new Part(shot.name(), shot.file(), scene, chosen);
    }
}
