package lightning.cli;

import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.PixelRegion;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.ViewOption;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.json.MatchReport;
import lightning.format.reference.ReferenceFile;
import lightning.render.RenderOptions;
import lightning.render.match.LightMatch;
import lightning.render.match.MatchChange;
import lightning.render.match.MatchResult;
import lightning.render.match.MatchSettings;
import lightning.render.match.MatchedScene;
import lightning.render.match.ReferenceImage;
import lightning.render.relight.Renderer;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Sets lights so that the picture comes closest to a reference image. */
@Command(name = "match", header = "Set lights so that the picture matches a reference image.", abbreviateSynopsis = true,
        description = {
            "Renders the scene once, and finds the intensities of its lights, and what --change names, with which the picture comes "
                    + "closest to a reference image. Prints each light's change, and the difference from the reference before and after.",
            "",
            "All but intensities and colors is found step by step, with renders of the scene at a small size. Lights must be near to where "
                    + "they belong: the search finds the nearest place that is better than all around it.",
            "",
            "The difference is the root mean square over all pixels and channels, relative to the reference's brightness there. "
                    + "Lights that are off stay off. The reference is an .exr, .hdr, .pfm, .png or .jpg of the picture's shape, in any size. "
                    + "The codes of a .png or .jpg are what the scene's view shall show; pixels that are clipped at white do not count.",
            "",
            "If two lights look alike in the picture, only their sum can be known; a note names them."},
        footer = {
            "Examples:",
            "  lightning match scenes/bird.jen --reference before.png -o matched.jen",
            "  lightning match scenes/bird.jen --reference before.pfm --exposure=free --change=colors"})
final class MatchCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Option(names = "--reference", paramLabel = "FILE", required = true, description = "Image that the picture shall match.")
    private Path reference;
    @Option(names = {"-o", "--output"}, paramLabel = "matched.jen",
            description = "Write the matched scene; keeps comments, order and unedited text.")
    private @Nullable Path output;
    @Option(names = "--lights", paramLabel = "NAMES", split = ",",
            description = "Lights and domes that may change, separated by commas; environment for the environment (default: all that shine).")
    private @Nullable List<String> lights;
    @Option(names = "--change", paramLabel = "WHAT", split = ",",
            description = "Also change these, separated by commas: ${COMPLETION-CANDIDATES} (rotation: that of the environment).")
    private Set<MatchChange> changes = EnumSet.noneOf(MatchChange.class);
    @Option(names = "--exposure", paramLabel = "fixed|free",
            description = "free: the reference's brightness does not count; the lights' mean brightness stays (default: fixed).")
    private MatchSettings.Reference exposure = MatchSettings.Reference.FIXED;
    @Option(names = "--white", paramLabel = "fixed|free",
            description = "free: neither the reference's brightness nor its tint counts (default: fixed).")
    private MatchSettings.Reference white = MatchSettings.Reference.FIXED;
    @Option(names = "--region", paramLabel = "X,Y,W,H", converter = PixelRegion.Converter.class,
            description = "Only this part of the reference counts, in its pixels.")
    private @Nullable PixelRegion region;
    @Mixin
    private ViewOption view;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;

    MatchCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (output != null) {
            PictureOutput.checkFile(output);
        }
        JenDocument document = input.read(console);
        if (output != null) {
            view.withFile(InputFiles.of(input.path(), List.of(document.scene())).with(reference)).check(output);
        }
        view.printNotes(console);
        Scene scene = picture.apply(document.scene());
        MatchSettings settings = new MatchSettings(chosen(document.scene()), Set.copyOf(changes), exposure, white, 0);
        ReferenceImage image = ReferenceFile.readFor(scene, reference, view.of(scene),
                region == null ? null : new int[] {region.x(), region.y(), region.width(), region.height()});
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count());
        MatchResult result;
        try (Renderer renderer = new Renderer(options); ProgressBar bar = new ProgressBar(console, "tracing")) {
            renderer.render(scene, bar);
            result = LightMatch.of(renderer.cache(), options, image, settings, bar);
        } catch (RefusalException e) {
            throw new BadInputException(Console.text("%s: %s", reference, e.getMessage()));
        }
        Scene matched = MatchedScene.of(document.scene(), result);
        MatchReport report = MatchReport.of(output == null ? null : output.toString(), result, image, document.scene(), matched);
        print(result, report);
        KeyedLightNotes.print(document.shot(), report.lights().stream().map(MatchReport.Matched::light).toList(), console);
        if (output != null) {
            document.withScene(matched).save(output);
        }
        console.report().setResult(report);
        return ExitCode.OK;
    }

    /** Returns the lights that may change; empty for all. */
    private Optional<Set<Contribution>> chosen(Scene scene) throws BadInputException {
        if (lights == null) {
            return Optional.empty();
        }
        Set<Contribution> chosen = new HashSet<>();
        for (String name : lights) {
            Optional<Light> light = scene.light(name);
            chosen.add(Contribution.named(scene, name).filter(Contribution.sources(scene)::contains)
                    .orElseThrow(() -> new BadInputException("--lights: there is no light " + Quote.of(name))));
            if (light.isPresent() && !scene.isActive(light.get())) {
                console.warn("%s is off, and stays off", name);
            }
        }
        return Optional.of(chosen);
    }

    private void print(MatchResult result, MatchReport report) {
        for (MatchReport.Moved moved : report.moved()) {
            console.print("%-24s %s %s to %s", moved.light(), moved.attribute(), moved.before(), moved.after());
        }
        for (MatchReport.Matched light : report.lights()) {
            List<Double> factors = light.factors();
            String change = Set.copyOf(factors).size() == 1 ? stops(factors.getFirst())
                    : factors.stream().map(MatchCommand::stops).collect(Collectors.joining(" "));
            console.print("%-24s intensity %s to %s (%s)", light.light(), digits(light.intensityBefore()), digits(light.intensityAfter()),
                    change);
        }
        console.print("difference from the reference: %.3g %% before, %.3g %% after", 100 * result.errorBefore(),
                100 * result.errorAfter());
        List<Double> scale = result.exposure();
        if (exposure == MatchSettings.Reference.FREE || white == MatchSettings.Reference.FREE) {
            console.print("the reference was scaled by %.4g %.4g %.4g", scale.get(0), scale.get(1), scale.get(2));
        }
        if (report.invalidPixels() > 0) {
            console.warn("%s: %s infinite or not a number, and did not count", reference,
                    report.invalidPixels() == 1 ? "1 pixel is" : report.invalidPixels() + " pixels are");
        }
        report.alike().forEach(pair -> console.warn("%s and %s look alike in this picture: only their sum is known", pair.getFirst(),
                pair.getLast()));
        report.unseen().forEach(light -> console.warn("%s does not light anything in this picture, and is unchanged", light));
    }

    private static String digits(double value) {
        return new BigDecimal(value).round(new MathContext(4)).stripTrailingZeros().toPlainString();
    }

    private static String stops(double factor) {
        return factor == 0 ? "off" : Console.text("%+.2f stops", Math.log(factor) / Math.log(2));
    }
}
