package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.format.json.MatchReport;
import lightning.format.json.ReportMapper;
import lightning.format.reference.ReferenceFile;
import lightning.render.match.LightMatch;
import lightning.render.match.MatchChange;
import lightning.render.match.MatchResult;
import lightning.render.match.MatchSettings;
import lightning.render.match.MatchedScene;
import lightning.render.match.ReferenceImage;
import lightning.render.relight.LightFilms;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;
import tools.jackson.databind.node.ObjectNode;

/** Request {@code match}: sets lights so that the picture comes closest to a reference image, as one step of the history. */
final class MatchRequest {
    private final SceneSession session;
    private final Request request;
    private final Scene scene;
    private final MatchSettings settings;
    private final ReferenceImage reference;

    MatchRequest(SceneSession session, Request request) throws IOException {
        this.session = session;
        this.request = request;
        scene = session.scene();
        Fields fields = request.fields();
        fields.flag("progress");
        settings = new MatchSettings(lights(fields), changes(fields), reference(fields, "exposure"), reference(fields, "white"), 0);
        reference = ReferenceFile.readFor(scene, Path.of(fields.string("reference")), SceneView.of(scene),
                fields.has("region") ? fields.integers("region", 4, 0, Integer.MAX_VALUE) : null);
    }

    private Optional<Set<String>> lights(Fields fields) {
        if (!fields.has("lights")) {
            return Optional.empty();
        }
        List<String> names = fields.strings("lights");
        List<String> shining = LightFilms.names(scene);
        for (int i = 0; i < names.size(); i++) {
            if (!shining.contains(names.get(i))) {
                throw Fields.bad("lights[" + i + "]", "no light " + Quote.of(names.get(i)) + " shines");
            }
        }
        return Optional.of(new HashSet<>(names));
    }

    private static Set<MatchChange> changes(Fields fields) {
        return !fields.has("change") ? Set.of()
                : fields.strings("change").stream().map(text -> choice("change", text, MatchChange.values())).collect(Collectors.toSet());
    }

    private static MatchSettings.Reference reference(Fields fields, String name) {
        return fields.optionalString(name).map(text -> choice(name, text, MatchSettings.Reference.values()))
                .orElse(MatchSettings.Reference.FIXED);
    }

    private static <E extends Enum<E>> E choice(String field, String text, E[] values) {
        return Arrays.stream(values).filter(value -> value.name().toLowerCase(Locale.ROOT).equals(text)).findFirst()
                .orElseThrow(() -> Fields.bad(field, "expected one of "
                        + Arrays.stream(values).map(value -> value.name().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "))
                        + ", found " + Quote.of(text)));
    }

    ObjectNode run() {
        session.update(request, 0);
        MatchResult result = session.compute(request, options -> {
            try {
                return LightMatch.of(session.renderer().cache(), options, reference, settings, request.progress());
            } catch (IllegalArgumentException e) {
                throw Fields.bad("reference", String.valueOf(e.getMessage()));
            }
        });
        Scene matched = MatchedScene.of(scene, result);
        ObjectNode answer = session.edit(matched);
        answer.setAll((ObjectNode) ReportMapper.MAPPER.valueToTree(MatchReport.of(null, result, scene, matched)));
        return answer;
    }
}
