package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.accuracy.Grade;

/** The results of {@code benchmarks/run} that are kept, by the names of its parts. */
record KeptRuns(Map<String, Results> parts) {
    static final Path FOLDER = Path.of("benchmarks", "results");
    private static final List<String> PARTS = List.of("figures", "grades", "effects", "surfaces", "cold", "editing", "meshes");
    private static final String ENDING = ".json";
    private static final Pattern CLEAN = Pattern.compile("[0-9a-f]{40}");
    private static final int LEAST_REPETITIONS = 3;

    static KeptRuns read(Path folder) throws IOException {
        Map<String, Results> parts = new LinkedHashMap<>();
        for (String part : PARTS) {
            parts.put(part, ResultsFile.readJson(folder.resolve(part + ENDING)));
        }
        return new KeptRuns(parts);
    }

    Results part(String name) {
        return parts.get(name);
    }

    Map<String, Run> runs() {
        Map<String, Run> runs = new LinkedHashMap<>();
        parts.forEach((name, results) -> runs.put(name, results.run()));
        return runs;
    }

    /** Why they must not be published; empty where they may. */
    List<String> faults() {
        List<String> faults = new ArrayList<>();
        parts.forEach((name, results) -> {
            Run run = results.run();
            if (!CLEAN.matcher(run.commit()).matches()) {
                faults.add(name + ": measured at " + run.commit() + ", expected a full commit without changes");
            }
            if (!run.complete()) {
                faults.add(name + ": the run was cancelled");
            }
            if (run.repetitions() < LEAST_REPETITIONS) {
                faults.add(name + ": " + run.repetitions() + " samples of each work, expected at least " + LEAST_REPETITIONS);
            }
            results.problems().forEach(problem -> faults.add(name + ": " + problem.where() + ": " + problem.what()));
            faults.addAll(unequal(name, results));
        });
        differing(faults, "builds", Run::commit);
        differing(faults, "machines", run -> run.machine().processors() + " × " + run.machine().processor() + ", " + run.machine().java());
        return faults;
    }

    private static List<String> unequal(String part, Results results) {
        return results.scenes().stream().flatMap(scene -> scene.edits().stream().flatMap(edit -> edit.values().stream()
                .filter(value -> value.rung(Grade.DEFAULT).error().values() != 0)
                .map(value -> part + ": " + scene.scene() + ", " + edit.edit() + ", " + value.value() + ": not equal to the full trace")))
                .toList();
    }

    private void differing(List<String> faults, String what, java.util.function.Function<Run, String> of) {
        Map<String, String> named =
                runs().entrySet().stream().collect(Collectors.groupingBy(e -> of.apply(e.getValue()), LinkedHashMap::new,
                        Collectors.mapping(Map.Entry::getKey, Collectors.joining(", "))));
        if (named.size() > 1) {
            faults.add("several " + what + ": " + named);
        }
    }

    /** The names of files in the folder of kept results that are none of them. */
    static List<String> others(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return List.copyOf(files.map(file -> file.getFileName().toString())
                    .filter(name -> !name.endsWith(ENDING) || !PARTS.contains(name.substring(0, name.length() - ENDING.length())))
                    .collect(Collectors.toCollection(TreeSet::new)));
        }
    }
}
