// Prints the errors and warnings of the Khronos validator for each file, a line for each: file, code, place, message.
const fs = require('fs');
const validator = require('gltf-validator');

(async () => {
    for (const file of process.argv.slice(2)) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 0});
        for (const issue of report.issues.messages.filter(message => message.severity < 2)) {
            console.log([file, issue.code, issue.pointer, issue.message].join(' '));
        }
        console.log('checked');
    }
})();
