package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.FileSentence;
import lightning.base.file.ShippedFile;
import lightning.bench.Failure;
import lightning.bench.NamedScene;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.jen.JenReader;

/**
 * The scenes of a benchmark that could be read, and why others could not.
 *
 * @param problems one for each file that could not be read
 */
record BenchScenes(List<NamedScene> scenes, List<Failure> problems) {
    /**
     * Reads scenes.
     *
     * @param files where none is named, all of the project's own scenes are read
     * @param own   the project's own scenes that are meant then; empty for all of them
     */
    static BenchScenes read(List<Path> files, List<String> own) throws IOException {
        List<NamedScene> scenes = new ArrayList<>();
        List<Failure> problems = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (Path file : files.isEmpty() ? own(own) : files.stream().map(ShippedFile::find).toList()) {
            try {
                scenes.add(new NamedScene(name(file, names), JenReader.read(file).scene(), file));
            } catch (JenException e) {
                problems.add(unread(file, e.problems().stream().map(Object::toString).collect(Collectors.joining("\n"))));
            } catch (IOException e) {
                problems.add(unread(file, FileSentence.of(e)));
            }
        }
        return new BenchScenes(scenes, problems);
    }

    private static Failure unread(Path file, String what) {
        return new Failure(Failure.Kind.UNREAD, file.toString(), what);
    }

    private static List<Path> own(List<String> names) throws IOException {
        Path folder = ShippedFile.find(ShippedFile.SCENES);
        if (!names.isEmpty()) {
            return names.stream().map(name -> folder.resolve(name + JenFile.ENDING)).toList();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> JenFile.isNamedSo(file.toString())).sorted().toList();
        }
    }

    /** The file's name without its ending, with a number where that was taken. */
    private static String name(Path file, Set<String> taken) {
        String plain = JenFile.stem(String.valueOf(file.getFileName()));
        String unique = plain;
        for (int i = 2; !taken.add(unique); i++) {
            unique = plain + "-" + i;
        }
        return unique;
    }
}
