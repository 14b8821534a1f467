package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.ResultsFile;
import lightning.render.measure.AccuracySetting;

/** Stored results of {@code benchmarks/run}, by part name. */
record StoredRuns(Map<String, BenchResults> parts) {
    static final Path FOLDER = Path.of("benchmarks", "results");
    private static final List<String> PARTS = List.of("figures", "grades", "effects", "surfaces", "cold", "editing", "meshes");
    /** Parts whose tables are empty while no run of them is stored. */
    private static final List<String> OPTIONAL_PARTS = List.of("modern", "indirect");
    /** Part with a document of its own, which names its build. It may be of another build than the rest. */
    static final String INDEPENDENT_PART = "indirect";
    /** Results of {@code benchmarks/peers}, with a document of their own. */
    static final Path PEERS = FOLDER.resolve("peers.json");
    private static final String EXTENSION = ".json";
    private static final Pattern CLEAN = Pattern.compile("[0-9a-f]{40}");
    private static final int MIN_REPETITIONS = 3;

    static StoredRuns read(Path folder) throws IOException {
        Map<String, BenchResults> parts = new LinkedHashMap<>();
        for (String part : PARTS) {
            parts.put(part, ResultsFile.readJson(folder.resolve(part + EXTENSION)));
        }
        for (String part : OPTIONAL_PARTS) {
            if (Files.exists(folder.resolve(part + EXTENSION))) {
                parts.put(part, ResultsFile.readJson(folder.resolve(part + EXTENSION)));
            }
        }
        return new StoredRuns(parts);
    }

    BenchResults part(String name) {
        return parts.get(name);
    }

    /** Returns the results of a part; empty if it is optional and not stored. */
    Optional<BenchResults> find(String name) {
        return Optional.ofNullable(parts.get(name));
    }

    Map<String, BenchRun> runs() {
        Map<String, BenchRun> runs = new LinkedHashMap<>();
        parts.forEach((name, results) -> runs.put(name, results.run()));
        return runs;
    }

    /** Returns the runs that must be of one build. */
    Map<String, BenchRun> commonRuns() {
        Map<String, BenchRun> runs = runs();
        runs.remove(INDEPENDENT_PART);
        return runs;
    }

    /** Returns the reasons against publishing them; empty if none. */
    List<String> findFaults() {
        List<String> faults = new ArrayList<>();
        parts.forEach((name, results) -> {
            BenchRun run = results.run();
            if (!CLEAN.matcher(run.commit()).matches()) {
                faults.add(name + ": measured at " + run.commit() + ", expected a full commit without changes");
            }
            if (!run.complete()) {
                faults.add(name + ": the run was canceled");
            }
            if (run.repetitions() < MIN_REPETITIONS) {
                faults.add(name + ": " + run.repetitions() + " samples of each work, expected at least " + MIN_REPETITIONS);
            }
            results.problems().forEach(problem -> faults.add(name + ": " + problem.where() + ": " + problem.what()));
            faults.addAll(differingPictures(name, results));
        });
        addIfDifferent(faults, commonRuns(), "builds", BenchRun::commit);
        addIfDifferent(faults, runs(), "machines",
                run -> run.machine().processors() + " × " + run.machine().processor() + ", " + run.machine().java());
        return faults;
    }

    private static List<String> differingPictures(String part, BenchResults results) {
        return Stream.of(differingEdits(part, results), differingModernEdits(part, results), differingIndirectEdits(part, results))
                .flatMap(faults -> faults).toList();
    }

    private static Stream<String> differingModernEdits(String part, BenchResults results) {
        return results.modern().stream().flatMap(scene -> scene.pictures().stream().flatMap(picture -> picture.edits().stream()
                .filter(edit -> !edit.equal())
                .map(edit -> part + ": " + scene.scene() + ", anti-aliasing " + picture.sampling().label() + ", "
                        + edit.edit() + ": not equal to the full trace")));
    }

    private static Stream<String> differingIndirectEdits(String part, BenchResults results) {
        return Stream.concat(results.indirect().costs().stream().flatMap(scene -> scene.edits().stream().filter(edit -> !edit.equal())
                .map(edit -> part + ": " + scene.scene() + ", indirect light, " + edit.edit() + ": not equal to the full trace")),
                results.indirect().absence().stream().filter(scene -> !scene.equal() || scene.bytes() != 0 || scene.rays() != 0)
                        .map(scene -> part + ": " + scene.scene() + ": absent indirect light is not free"));
    }

    private static Stream<String> differingEdits(String part, BenchResults results) {
        return results.scenes().stream().flatMap(scene -> scene.edits().stream().flatMap(edit -> edit.values().stream()
                .filter(value -> value.point(AccuracySetting.DEFAULT).error().values() != 0)
                .map(value -> part + ": " + scene.scene() + ", " + edit.edit() + ", " + value.value() + ": not equal to the full trace")));
    }

    private static void addIfDifferent(List<String> faults, Map<String, BenchRun> runs, String name,
            java.util.function.Function<BenchRun, String> value) {
        Map<String, String> named =
                runs.entrySet().stream().collect(Collectors.groupingBy(e -> value.apply(e.getValue()), LinkedHashMap::new,
                        Collectors.mapping(Map.Entry::getKey, Collectors.joining(", "))));
        if (named.size() > 1) {
            faults.add("several " + name + ": " + named);
        }
    }

    /** Returns the names of other files in the folder of stored results. */
    static List<String> otherFiles(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return List.copyOf(files.map(file -> file.getFileName().toString())
                    .filter(name -> !name.equals(PEERS.getFileName().toString())
                            && Stream.concat(PARTS.stream(), OPTIONAL_PARTS.stream()).noneMatch(part -> name.equals(part + EXTENSION)))
                    .collect(Collectors.toCollection(TreeSet::new)));
        }
    }
}
