package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.ShippedFile;
import lightning.bench.NamedScene;
import lightning.bench.result.MeasurementFailure;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.jen.JenReader;

/**
 * Scenes of a benchmark, and the files that could not be read.
 *
 * @param problems one entry for each unreadable file
 */
record BenchScenes(List<NamedScene> scenes, List<MeasurementFailure> problems) {
    /**
     * Reads scenes.
     *
     * @param files scene files; if empty, the project's own scenes are read
     * @param defaultScenes names of the project's own scenes to read if {@code files} is empty; empty for all
     */
    static BenchScenes read(List<Path> files, List<String> defaultScenes) throws IOException {
        List<NamedScene> scenes = new ArrayList<>();
        List<MeasurementFailure> problems = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (Path file : files.isEmpty() ? bundledScenes(defaultScenes) : files.stream().map(ShippedFile::resolve).toList()) {
            try {
                scenes.add(new NamedScene(name(file, names), JenReader.read(file).requireAllFiles().scene(), file));
            } catch (JenException e) {
                problems.add(unreadable(file, e.problems().stream().map(Object::toString).collect(Collectors.joining("\n"))));
            } catch (IOException e) {
                problems.add(unreadable(file, FileErrorMessage.of(e)));
            }
        }
        return new BenchScenes(scenes, problems);
    }

    /**
     * Returns the scenes with one sample per pixel, except some that keep their anti-aliasing.
     *
     * @param kept names of scenes
     */
    BenchScenes withoutAntialiasing(Collection<String> kept) {
        return new BenchScenes(scenes.stream().map(scene -> kept.contains(scene.name()) ? scene : scene.withoutAntialiasing()).toList(),
                problems);
    }

    private static MeasurementFailure unreadable(Path file, String message) {
        return new MeasurementFailure(MeasurementFailure.Kind.UNREAD, file.toString(), message);
    }

    private static List<Path> bundledScenes(List<String> names) throws IOException {
        Path folder = ShippedFile.resolve(ShippedFile.SCENES);
        if (!names.isEmpty()) {
            return names.stream().map(name -> folder.resolve(name + JenFile.EXTENSION)).toList();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> JenFile.isJenFileName(file.toString())).sorted().toList();
        }
    }

    /** Returns the file's name without its extension, with a number appended if that name is in use. */
    private static String name(Path file, Set<String> usedNames) {
        String stem = JenFile.stem(String.valueOf(file.getFileName()));
        String unique = stem;
        for (int i = 2; !usedNames.add(unique); i++) {
            unique = stem + "-" + i;
        }
        return unique;
    }
}
