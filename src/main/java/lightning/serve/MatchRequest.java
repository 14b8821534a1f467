package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.json.MatchReport;
import lightning.format.json.ReportMapper;
import lightning.format.reference.ReferenceFile;
import lightning.render.match.LightMatch;
import lightning.render.match.MatchChange;
import lightning.render.match.MatchResult;
import lightning.render.match.MatchSettings;
import lightning.render.match.MatchedScene;
import lightning.render.match.ReferenceImage;
import lightning.render.relight.SceneView;
import lightning.scene.Contribution;
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
        settings = new MatchSettings(lights(fields), changes(fields), fields.choice("exposure", MatchSettings.Reference.FIXED),
                fields.choice("white", MatchSettings.Reference.FIXED), 0);
        reference = ReferenceFile.readFor(scene, Path.of(fields.string("reference")), SceneView.of(scene),
                fields.has("region") ? fields.integers("region", 4, 0, Integer.MAX_VALUE) : null);
    }

    private Optional<Set<Contribution>> lights(Fields fields) {
        if (!fields.has("lights")) {
            return Optional.empty();
        }
        List<String> names = fields.strings("lights");
        List<Contribution> shining = Contribution.shining(scene);
        Set<Contribution> lights = new HashSet<>();
        for (int i = 0; i < names.size(); i++) {
            Optional<Contribution> light = Contribution.named(scene, names.get(i)).filter(shining::contains);
            if (light.isEmpty()) {
                throw Fields.bad("lights[" + i + "]", "no light " + Quote.of(names.get(i)) + " shines");
            }
            lights.add(light.get());
        }
        return Optional.of(lights);
    }

    private static Set<MatchChange> changes(Fields fields) {
        return !fields.has("change") ? Set.of()
                : fields.strings("change").stream().map(text -> Fields.choice("change", text, MatchChange.class))
                        .collect(Collectors.toSet());
    }

    ObjectNode run() {
        session.update(request, 0);
        MatchResult result = session.compute(request, options -> {
            try {
                return LightMatch.of(session.renderer().cache(), options, reference, settings, request.progress());
            } catch (RefusalException e) {
                throw Fields.bad("reference", e.getMessage());
            }
        });
        Scene matched = MatchedScene.of(scene, result);
        ObjectNode answer = session.edit(matched);
        answer.setAll((ObjectNode) ReportMapper.MAPPER.valueToTree(MatchReport.of(null, result, reference, scene, matched)));
        return answer;
    }
}
