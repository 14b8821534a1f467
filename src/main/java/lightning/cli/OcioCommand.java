package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.report.OcioReport;
import lightning.format.image.CubeLutReader;
import lightning.format.ocio.OcioConfig;
import lightning.format.ocio.OcioReference;
import lightning.format.ocio.OcioView;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists the displays and views of an OpenColorIO configuration, or writes one as a table. */
@Command(name = "ocio", header = "List the views of OpenColorIO, or bake one to a LUT.", abbreviateSynopsis = true,
        description = {
            "Lists displays and views of an OpenColorIO configuration: a .ocio or .ocioz file, or one that OpenColorIO contains, such as "
                    + "ocio://default. Needs Python with the package opencolorio.",
            "",
            "With --bake, writes a view as a .cube LUT and prints its error. The LUT shows the view later without OpenColorIO: "
                    + "--view look.cube."},
        footer = {
            "Examples:",
            "  lightning ocio ocio://default",
            "  lightning ocio ocio://default --bake \"sRGB - Display/Raw\" -o raw.cube"})
final class OcioCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", arity = "0..1", paramLabel = "CONFIG",
            description = "Configuration (default: that of the environment variable OCIO).")
    private String config = "";
    @Option(names = "--bake", paramLabel = "DISPLAY/VIEW", description = "Write this view as a LUT; DISPLAY alone for its default view.")
    private @Nullable String view;
    @Option(names = {"-o", "--output"}, paramLabel = "look.cube", description = "LUT to write.")
    private @Nullable Path output;

    OcioCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if ((view == null) != (output == null)) {
            throw new BadInputException("ocio: expected --bake DISPLAY/VIEW and -o look.cube together");
        }
        if (output != null) {
            checkOutput(output);
        }
        OcioConfig read = OcioConfig.read(OcioReference.config(config, System.getenv(OcioReference.VARIABLE)), Progress.NONE);
        if (view != null && output != null) {
            bake(read, view, output);
        } else {
            list(read);
        }
        return ExitCode.OK;
    }

    private static void checkOutput(Path file) throws IOException, BadInputException {
        PictureOutput.checkFile(file);
        if (!file.toString().toLowerCase(Locale.ROOT).endsWith(CubeLutReader.EXTENSION)) {
            throw new BadInputException(Console.text("%s: a LUT is written to %s", file, CubeLutReader.EXTENSION));
        }
    }

    private void list(OcioConfig read) {
        for (OcioConfig.Display display : read.displays()) {
            console.print("%s", PrintableText.escape(display.name()));
            display.views()
                    .forEach(v -> console.print("  %s%s", PrintableText.escape(v), v.equals(display.defaultView()) ? " (default)" : ""));
        }
        console.report().setResult(new OcioReport(read.source(), read.displays().stream()
                .map(d -> new OcioReport.Display(d.name(), d.views(), d.defaultView())).toList(), null));
    }

    private void bake(OcioConfig read, String name, Path file) throws IOException {
        OcioView baked = OcioView.bake(read, read.find(name), Progress.NONE);
        baked.write(file);
        console.print("%s: %s", file, baked.title());
        console.print("%s", baked.errorText());
        OcioView.Facts facts = baked.facts();
        if (!facts.note().isEmpty()) {
            console.warn("%s: %s", Quote.path(read.source()), facts.note());
        }
        console.report()
                .setResult(new OcioReport(read.source(), List.of(), new OcioReport.Lut(file.toString(), baked.display(), baked.view(),
                        facts.low(), facts.high(), facts.largestError(), facts.error99(), facts.meanError(), facts.colors())));
    }
}
